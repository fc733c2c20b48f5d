#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "client/demo/demo.h"
#include "client/gl/game_view.h"
#include "client/gl/gl_context.h"
#include "client/lobby/shipped_levels.h"
#include "client/play/client_options.h"
#include "client/play/match/live_match.h"
#include "client/play/offscreen/local_game.h"
#include "client/play/replay_screen.h"
#include "client/time/clock.h"
#include "client/ui/settings.h"
#include "platon/game/game.h"
#include "protocol/program_error.h"
#include "protocol/time.h"

// What the program does without a window. Each class does a part of it in each call, until it is done.
namespace platon {

/// Plays a match. Draws the last frame if a screenshot is requested.
class OffscreenPlay {
 public:
  static constexpr double kSeconds = 10;  ///< if the options say nothing else

  /// Starts to connect. Throws as LiveMatch, and std::runtime_error if there is no OpenGL.
  OffscreenPlay(const ClientOptions& options, const Clock& clock);

  /// Plays on. Throws ProgramError if the match has ended.
  void update();
  /// Draws and leaves. Throws ProgramError if the match has not begun yet.
  void finish();

 private:
  Input choose(const Game& game, std::uint32_t slot);

  ClientOptions options_;
  LiveMatch match_;
  Offscreen offscreen_;
  Demo demo_{shippedWay};
};

/// Plays one level with the demonstration's players and writes every frame to a folder. There is no server, window or
/// clock, so the same options give the same frames.
class FramePlay {
 public:
  /// Throws std::runtime_error if there is no OpenGL.
  FramePlay(const ClientOptions& options, std::shared_ptr<const Level> level);

  /// Whether all frames are written.
  bool done() const { return tick_ == endTick_; }
  /// Plays a tick, and writes the frame that belongs to it. Throws std::runtime_error if it cannot be written.
  void advance();

 private:
  static constexpr double kSeconds = 4;
  static constexpr std::uint32_t kTicksBetweenStarts = kTicksPerSecond;

  void play();
  void writeFrame(std::uint32_t frame);

  FrameOptions options_;
  std::uint32_t ticksPerFrame_;
  std::uint32_t firstTick_;  // of the game, on which a frame is written
  std::uint32_t endTick_;
  std::uint32_t tick_ = 0;
  Offscreen offscreen_;
  GameView view_;
  LocalGame game_;
  std::vector<Demo> demos_;  // by slot
};

/// Draws a moment of a recording.
class OffscreenReplay {
 public:
  /// Starts to read options.replay.
  OffscreenReplay(const ClientOptions& options, const Settings& settings, Time now);

  /// Returns whether the file has been read, and tells on stderr how far it is if that takes long. Throws ProgramError
  /// with one sentence if it cannot be played.
  bool read(Time now);
  /// Why a file is not played whose reading was stopped.
  ProgramError stopped() const;
  /// Draws the moment after the time of the options, or without one the end, and writes it to options.screenshot. The
  /// file has been read. Throws std::runtime_error if there is no OpenGL.
  void draw();

  const ReplayViewer& viewer() const { return *replay_.viewer(); }

 private:
  ClientOptions options_;
  Settings settings_;
  ReplayPlay replay_;
  Time toldAt_;
};

}  // namespace platon
