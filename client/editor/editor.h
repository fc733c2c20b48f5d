#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "client/editor/ball_play.h"
#include "client/editor/edited_level.h"
#include "client/editor/editor_camera.h"
#include "client/editor/editor_menu.h"
#include "client/editor/editor_panel.h"
#include "client/editor/editor_tools.h"

namespace platon {

/// The level editor without window, file and thread: events go in, pictures and wishes come out. Its tools edit the
/// level, its camera shows it, a ball plays it; the editor passes the events on and says what has happened.
class Editor {
 public:
  /// `level` has a level that can be shown; `file` is its name for messages.
  Editor(std::string file, EditedLevel level);

  /// The pictures have w × h pixels; the menu is enlarged as Settings::uiScale says.
  void resize(std::uint32_t w, std::uint32_t h, double uiScale = 1);
  void handle(const KeyEvent& event);
  void handle(const PointerEvent& event);
  /// Lets `seconds` pass: plays the ball.
  void advance(double seconds);

  /// Whether the user has asked to save since the last call.
  bool takeSave() { return menu_.takeSave(); }
  /// The user has asked to close the window.
  void askToLeave() { menu_.open(); }
  /// Whether the user has left. With unsaved changes, they are to be dropped.
  bool leaving() const { return menu_.leaving(); }
  bool fullscreen() const { return fullscreen_; }
  void setFullscreen(bool fullscreen) { fullscreen_ = fullscreen; }

  const EditedLevel& level() const { return level_; }
  void markSaved();
  void markUnsaved() { level_.markUnsaved(); }
  /// The text could not be saved, because of this fault.
  void failSave(const std::string& fault);
  void reload(std::string_view text);
  /// Shows this text until the next one.
  void say(std::string message) { message_ = std::move(message); }

  /// The level to analyse: that of the text, or while a ball is played the one that starts with it.
  const std::shared_ptr<const Level>& analysed() const;
  void setReport(LevelReport report);

  Camera camera() const;
  Scene scene() const;
  EditorStatus status() const;
  const Menu& menu() const { return menu_.menu(); }
  /// The picture of the menu; empty while it is closed.
  Overlay menuOverlay() const { return menu_.overlay(); }

 private:
  const SolidMesh& mesh() const { return level_.stage()->mesh; }
  void handleInPlay(const KeyEvent& event);
  void handleCommand(const KeyEvent& event);
  void handleEdit(Key key, bool shift);
  void undo(bool back);
  void showOther(const std::shared_ptr<const Level>& before);
  void placeBall();
  int upOfBall(int face) const;

  std::string file_;
  EditedLevel level_;
  EditorTools tools_;
  EditorCamera view_;
  std::optional<BallPlay> play_;
  EditorMenu menu_;
  bool fullscreen_ = false;
  bool help_ = false;
  bool showReached_ = true;
  std::string message_;
  LevelReport report_;
  FaceMarks below_;  // of the report
};

}  // namespace platon
