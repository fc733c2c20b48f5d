#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "client/gl/game_view.h"
#include "client/menu/menu_page.h"
#include "client/play/game_desk.h"
#include "client/play/screen.h"
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

/// A recording that is watched. A thread reads it, so that the window stays alive meanwhile; the end of this object
/// waits at most for the present MiB, block or tick of the recording.
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
  /// These two return whether the viewer wants to leave.
  bool handle(const KeyEvent& event);
  bool handle(PointerEvent event, const GameView& view, const Settings& settings);
  void draw(GameView& view, const Settings& settings, double seconds, const ReplayContext& context = {}) const;

  const std::filesystem::path& file() const { return file_; }
  /// What is shown while the file is being read: its name, and how far that is.
  std::string readingText() const;
  /// Why the recording cannot be played, a sentence; empty: it can, as far as is known.
  const std::string& fault() const { return fault_; }
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
};

/// Tells the player why a recording that is dropped on a match is not watched.
inline constexpr const char* kDropRefused = "leave the game to watch a recording";

/// A recording in the window of the program, in front of the title or of a match that stands still.
class ReplayScreen : public Screen {
 public:
  enum class Behind : std::uint8_t { kTitle, kMatch };

  /// `desk` outlives the screen.
  ReplayScreen(GameDesk& desk, const std::filesystem::path& file, MedalsOf medalsOf, Behind behind)
      : desk_(&desk), play_(file), medalsOf_(std::move(medalsOf)), behind_(behind) {}

  Next handle(const WindowEvent& event) override;
  Next update(const Frame& frame) override;
  void draw(const Frame& frame) override;
  Time frameTime() const override { return desk_->frameTime(false); }
  Image read() const override { return desk_->view.read(); }

  /// Null while the file is being read.
  const ReplayViewer* viewer() const { return play_.viewer(); }

 private:
  Next handleKey(const KeyEvent& event);
  Next drop(const std::filesystem::path& file);

  GameDesk* desk_;
  ReplayPlay play_;
  MedalsOf medalsOf_;
  Behind behind_;
  std::optional<std::optional<MedalTimes>> medals_;  // of the level, since the file has been read
};

/// The page for a recording that cannot be played: the player can try it again, or go back.
MenuPage unplayablePage(const ReplayEnd& end, const std::function<void()>& retry, const std::function<void()>& back);

}  // namespace platon
