#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "client/editor/ball_play.h"
#include "client/editor/edit_tool.h"
#include "client/editor/edited_level.h"
#include "client/editor/editor_camera.h"
#include "client/editor/editor_marks.h"
#include "client/editor/editor_panel.h"
#include "client/editor/gesture.h"
#include "client/menu/menu.h"
#include "client/scene/scene.h"
#include "client/ui/controls/input_mapper.h"
#include "client/ui/font.h"
#include "client/ui/key.h"
#include "client/ui/pointer_event.h"
#include "client/ui/steering.h"

namespace platon {

/// The level editor without window, file and thread: events go in, pictures and wishes come out.
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
  bool takeSave() { return std::exchange(wantsSave_, false); }
  /// The user has asked to close the window.
  void askToLeave();
  /// Whether the user has left. With unsaved changes, they are to be dropped.
  bool leaving() const { return leaving_; }
  bool fullscreen() const { return fullscreen_; }

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
  const Menu& menu() const { return menu_; }
  /// The picture of the menu; empty while it is closed.
  Overlay menuOverlay() const { return menu_.overlay(font_, true); }

 private:
  static constexpr std::array<double, 6> kGrids{1, 5, 10, 20, 40, 60};  // level units
  static constexpr double kReach = 9;                                   // of the pointer, units of the virtual screen

  const SolidMesh& mesh() const { return stage_->mesh; }
  const std::vector<EditedSegment>& segments() const { return level_.document().segments(); }
  SnapOptions snapOptions(bool free) const;
  void edit(const std::function<void(LevelDocument&)>& change);
  void showLevel();

  // Pointer.
  void movePointer(const PointerEvent& event);
  void press(const PointerEvent& event);
  void beginMove();
  void finishGesture();
  std::optional<std::size_t> find(const EditedSegment& segment) const;
  SegmentWord nextWord(SegmentWord word, bool back) const;
  void cycleWord(std::size_t segment, bool back);
  void placeStart(const FacePlace& at);
  void placeBall();
  int turnOfStart() const;
  double upOfPicture(int face) const;
  int upOfStart(int face) const;
  int upOfBall(int face) const;

  // Keys.
  MenuPage leavePage();
  void closeMenu();
  void saveAndLeave();
  void handleInPlay(const KeyEvent& event);
  void handleCommand(const KeyEvent& event);
  bool turnView(const KeyEvent& event);
  void handleEdit(Key key, bool shift);
  void typeDigit(int digit);
  void changeGrid(int step);
  void eraseSelected();
  void flip();
  void escape();
  void choose(EditTool tool);
  void centre();

  std::string file_;
  EditedLevel level_;
  std::shared_ptr<const Level> shown_;
  std::shared_ptr<const StageModel> stage_;
  std::optional<Game> idle_;  // of shown_, without players
  EditorCamera view_;
  std::uint32_t width_ = 1280;
  std::uint32_t height_ = 720;

  EditTool tool_ = EditTool::kSelect;
  SegmentWord word_;                  // of the next segment
  int digits_ = 0;                    // of its number that have just been typed
  std::size_t grid_ = 2;              // index into kGrids
  std::optional<FacePlace> pointer_;  // on the solid
  glm::dvec2 screen_{0};              // of the pointer
  bool free_ = false;                 // Alt is held
  std::optional<PickedSegment> hovered_;
  std::optional<std::size_t> selected_;
  std::optional<Gesture> gesture_;
  bool turning_ = false;  // the button that turns the solid is held

  std::optional<BallPlay> play_;
  Camera playCamera_;
  InputMapper mapper_;
  Steering steering_;
  double untilTick_ = 0;  // seconds

  Font font_;
  Menu menu_;
  bool wantsSave_ = false;
  bool leaveWhenSaved_ = false;
  bool leaving_ = false;
  bool fullscreen_ = false;
  bool help_ = false;
  bool showReached_ = true;
  std::string message_;
  LevelReport report_;
  FaceMarks below_;
};

}  // namespace platon
