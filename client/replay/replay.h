#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <stop_token>
#include <string>
#include <variant>
#include <vector>

#include "platon/game/game.h"
#include "platon/game/recording_reader.h"

namespace platon {

/// A recording that has been read and played once from its start to its end: every hash and every checkpoint agreed
/// with the game of this program. Keeps states in between, from which each tick is reached soon.
class Replay {
 public:
  /// Most states that are kept, whatever the length of the recording.
  static constexpr std::uint32_t kMaxStates = 256;
  /// Fewest ticks between two of them.
  static constexpr std::uint32_t kMinInterval = 60;
  /// Most ticks of a recording, each counted once per slot: playing them takes some seconds.
  static constexpr std::uint64_t kMaxWork = std::uint64_t{1} << 24;
  static constexpr const char* kTooLong = "is too long to be played";
  static constexpr const char* kStopped = "was not read to its end";
  /// What a block adds to that.
  static std::uint64_t workOf(const RecordedBlock& block) { return std::uint64_t{block.ticks()} * (block.slots + 1); }
  /// Most bytes of a recording.
  static constexpr std::size_t kMaxBytes = std::size_t{64} << 20;

  /// The replay of a recording, or why there is none, as the end of a sentence that begins with the name of its file:
  /// it is damaged, cut off or too long, or was made by other rules. Ends with the present block or tick when it is
  /// asked to stop.
  static std::variant<std::shared_ptr<const Replay>, std::string> read(std::span<const std::uint8_t> recording,
                                                                       const std::stop_token& stop = {});

  const std::shared_ptr<const Level>& level() const { return start_.sharedLevel(); }
  /// Number of recorded ticks.
  std::uint32_t ticks() const { return ticks_; }
  /// Inputs of a tick, by slot. tick < ticks().
  std::span<const Input> inputsOf(std::uint32_t tick) const;
  /// The game after the first `tick` recorded ticks. tick ≤ ticks(). Advances at most by interval() ticks.
  Game gameAfter(std::uint32_t tick) const;
  /// Ticks between two states that are kept.
  std::uint32_t interval() const { return interval_; }

 private:
  explicit Replay(Game start) : start_(std::move(start)) {}
  std::string readBlocks(RecordingReader& reader, RecordedBlock first, const std::stop_token& stop);
  std::string add(RecordedBlock block);
  std::string play(const std::stop_token& stop);

  Game start_;
  std::vector<RecordedBlock> blocks_;  // not empty; the last one has no ticks
  std::uint32_t ticks_ = 0;
  std::uint64_t work_ = 0;
  std::uint32_t interval_ = kMinInterval;
  std::vector<std::vector<std::uint8_t>> states_;  // after 0, interval_, 2 · interval_ … ticks
};

}  // namespace platon
