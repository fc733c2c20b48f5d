#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "client/editor/editor.h"
#include "client/editor/level_analysis.h"
#include "client/files/edit_file.h"
#include "client/gl/offscreen.h"
#include "client/gl/renderer.h"
#include "client/gl/window.h"
#include "client/play/client_options.h"
#include "client/time/clock.h"
#include "client/ui/font.h"
#include "client/ui/settings.h"

namespace platon {

/// Edits a level in a window, or with options.offscreen draws it once.
class EditPlay {
 public:
  /// Throws ProgramError if the level file cannot be read, has no part that can be shown, or if no window can be
  /// opened.
  EditPlay(const ClientOptions& options, const Clock& clock);

  /// Edits until the user leaves, the time limit of the options is reached or `stopRequested` returns true.
  void run(const std::function<bool()>& stopRequested);

  const Editor& editor() const { return editor_; }

 private:
  void runWindow(const std::function<bool()>& stopRequested);
  void runOffscreen(const std::function<bool()>& stopRequested);
  bool timeIsLeft(Moment now) const;
  void handleEvents();
  void updateAnalysis();
  void save();
  void takeFileChange(const std::optional<std::string>& text);
  void showTitle();
  void draw();
  void show();
  void takeScreenshot();

  ClientOptions options_;
  Clock clock_;
  EditFile file_;
  Editor editor_;
  std::unique_ptr<Window> window_;  // one of these two
  std::optional<Offscreen> offscreen_;
  Settings settings_;  // of the player, who sees the window; off-screen, the defaults
  Font font_;
  Renderer renderer_;
  LevelAnalysis analysis_;
  std::shared_ptr<const Level> analysed_;  // what the analysis was started with
  std::string title_;
  Moment startedAt_;
  bool conflicts_ = false;  // another program has changed the file, and its text is not shown
};

}  // namespace platon
