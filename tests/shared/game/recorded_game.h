#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "platon/game/recorder.h"
#include "tests/shared/game/played_game.h"
#include "tests/sim/churn.h"

namespace platon {

/// A game of seeded players and its recording.
struct RecordedGame {
  std::vector<std::uint8_t> recording;
  std::vector<std::vector<Input>> inputs;         ///< inputs of each tick
  std::vector<std::uint64_t> hashes;              ///< hash after each tick
  std::vector<std::vector<std::uint8_t>> states;  ///< state before each tick, and after the last
};

inline std::shared_ptr<const Level> recordedLevel() {
  static const auto loaded = cubeLevel("0 0 -180 0", {"-240 -200 240 -200\n60 -90 150 -90"});
  return loaded;
}

/// Plays and records `ticks` ticks on recordedLevel().
inline RecordedGame recordGame(std::uint32_t ticks, std::uint32_t checkpointTicks, std::uint32_t slots = 3) {
  constexpr std::uint64_t kSeed = 29;
  Game game(recordedLevel());
  Recorder recorder(game, checkpointTicks);
  sim::Churn churn(kSeed, slots);
  RecordedGame played;
  const auto takeBytes = [&] {
    const auto bytes = recorder.takeBytes();
    played.recording.insert(played.recording.end(), bytes.begin(), bytes.end());
  };
  for (std::uint32_t tick = 0; tick < ticks; ++tick) {
    played.states.push_back(game.save());
    played.inputs.push_back(churn.next());
    game.advance(played.inputs.back());
    played.hashes.push_back(game.hash());
    recorder.record(played.inputs.back(), game);
    takeBytes();
  }
  played.states.push_back(game.save());
  recorder.finish(game);
  takeBytes();
  return played;
}

}  // namespace platon
