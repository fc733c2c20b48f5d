#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "client/gl/game_view.h"
#include "client/replay/replay_viewer.h"
#include "client/ui/medal.h"
#include "client/ui/settings.h"
#include "protocol/work/worker.h"

namespace platon {

/// What is shown of a replay besides what it holds.
struct ReplayContext {
  bool gamepad = false;                ///< the bar names its buttons
  std::optional<MedalTimes> medals{};  ///< of the level; nothing: it has none
};

/// Draws a replay with its bar, `seconds` after the last picture.
void drawReplay(const ReplayViewer& viewer, GameView& view, Settings settings, double seconds,
                const ReplayContext& context = {});

/// A recording in the window of the program. A thread reads it, so that the window stays alive meanwhile; the end of
/// this object waits at most for the present MiB, block or tick of the recording.
class ReplayPlay {
 public:
  /// Starts to read the file. A file that cannot be played gives a fault.
  explicit ReplayPlay(std::filesystem::path file);

  /// Longest time that `advance` plays in one call, seconds: ticks that take longer than they last would otherwise cost
  /// more from picture to picture.
  static constexpr double kMaxSeconds = 0.1;

  /// Plays on for `seconds`, at most kMaxSeconds, as soon as the file has been read.
  void advance(double seconds);
  /// Shows the picture after so many seconds. The file has been read.
  void skipTo(double seconds) { viewer_->skipTo(seconds); }
  void handle(const KeyEvent& event);
  void handle(PointerEvent event, const GameView& view, const Settings& settings);
  void draw(GameView& view, const Settings& settings, double seconds, const ReplayContext& context = {}) const;

  const std::filesystem::path& file() const { return file_; }
  /// What is shown while the file is being read: its name, and how far that is.
  std::string readingText() const;
  /// Why the recording cannot be played, a sentence; empty: it can, as far as is known.
  const std::string& fault() const { return fault_; }
  /// Whether the viewer wants to leave.
  bool leaving() const { return leaving_; }
  /// Null while the file is being read, and if it cannot be played.
  const ReplayViewer* viewer() const { return viewer_ ? &*viewer_ : nullptr; }

 private:
  using Read = std::variant<std::shared_ptr<const Replay>, std::string>;

  void take(JobResult<Read> read);

  std::filesystem::path file_;
  std::shared_ptr<ReplayProgress> progress_ = std::make_shared<ReplayProgress>(0);  // of reading_
  Worker<Read> reading_;
  std::optional<ReplayViewer> viewer_;
  std::string fault_;
  bool leaving_ = false;
};

}  // namespace platon
