#pragma once

#include <memory>
#include <optional>
#include <string>

#include "client/editor/editor.h"
#include "client/editor/level_analysis.h"
#include "client/files/edit_file.h"
#include "client/gl/renderer.h"
#include "client/gl/window.h"
#include "client/play/client_options.h"
#include "client/play/screen.h"
#include "client/ui/font.h"
#include "client/ui/settings.h"

namespace platon {

/// A level file that is edited: the editor, the file, and the analysis of what the editor shows.
class EditSession {
 public:
  /// Throws ProgramError if the file cannot be read, or has no part that can be shown. `solid`: of a new level.
  EditSession(const std::string& file, SolidKind solid);

  Editor& editor() { return editor_; }
  const Editor& editor() const { return editor_; }
  /// Starts to analyse what the editor shows now, and shows the results of the analysis. Returns whether it has
  /// finished.
  bool analyse();
  /// Saves the text. What another program has written meanwhile is replaced only when the user asks again.
  void save();
  /// Shows what another program has written. Call in each frame.
  void followFile(Time now) { takeFileChange(file_.pollChange(FileWatch::Time(now))); }

 private:
  void takeFileChange(const std::optional<std::string>& text);

  EditFile file_;
  Editor editor_;
  LevelAnalysis analysis_;
  std::shared_ptr<const Level> analysed_;  // what the analysis was started with
  bool conflicts_ = false;                 // another program has changed the file, and its text is not shown
};

/// Draws the editor. Requires the current OpenGL context of a Window or an Offscreen, which must outlive it.
class EditorPicture {
 public:
  explicit EditorPicture(const Settings& settings);

  void setQuality(const Quality& quality) { renderer_.setQuality(quality); }
  void resize(std::uint32_t width, std::uint32_t height) { renderer_.resize(width, height); }
  void draw(const Editor& editor);
  void present() { renderer_.present(); }
  Image read() const { return renderer_.read(); }

 private:
  Settings settings_;
  Font font_;
  Renderer renderer_;
};

/// The level editor in a window.
class EditorScreen : public Screen {
 public:
  /// `settings`: of the player. `screenshot`: file for the picture at the end; empty: none. Session and window outlive
  /// the screen.
  EditorScreen(EditSession& session, Window& window, const Settings& settings, std::string screenshot);

  Next handle(const WindowEvent& event) override;
  Next update(const Frame& frame) override;
  void draw(const Frame& frame) override;
  Time frameTime() const override { return frameTimeOf(!window_->focused(), settings_.frameCap); }
  Image read() const override { return picture_.read(); }
  void leave() override;

  const Editor& editor() const { return session_->editor(); }

 private:
  void fit();
  void showTitle();

  EditSession* session_;
  Window* window_;
  Settings settings_;
  EditorPicture picture_;
  std::string screenshot_;
  std::string title_;
};

}  // namespace platon
