#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "client/demo/demo.h"
#include "client/gl/game_view.h"
#include "client/gl/offscreen.h"
#include "client/play/client_options.h"
#include "client/play/offscreen/local_game.h"
#include "platon/game/game.h"

namespace platon {

/// Plays one level with the demonstration's players and writes every frame to a folder. There is no server, window or
/// clock, so the same options give the same frames.
class FramePlay {
 public:
  /// Throws std::runtime_error if there is no OpenGL.
  FramePlay(const ClientOptions& options, std::shared_ptr<const Level> level);

  /// Plays until all frames are written or `stopRequested` returns true. Throws std::runtime_error if a frame cannot
  /// be written.
  void run(const std::function<bool()>& stopRequested);

 private:
  static constexpr double kSeconds = 4;
  static constexpr std::uint32_t kTicksBetweenStarts = kTicksPerSecond;

  void advance();
  void writeFrame(std::uint32_t frame);

  FrameOptions options_;
  std::uint32_t ticksPerFrame_;
  std::uint32_t firstTick_;  // of the game, on which a frame is written
  std::uint32_t endTick_;
  Offscreen offscreen_;
  GameView view_;
  LocalGame game_;
  std::vector<Demo> demos_;  // by slot
};

}  // namespace platon
