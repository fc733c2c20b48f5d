#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "platon/game/input.h"
#include "platon/game/level.h"

namespace platon {

/// The ticks from one checkpoint to the next.
struct RecordedBlock {
  std::size_t offset = 0;             ///< in the recording, bytes
  std::uint32_t first = 0;            ///< tick before which it starts
  std::vector<std::uint8_t> state;    ///< then, as Game::save gives it
  std::vector<std::uint64_t> hashes;  ///< of the game after each tick; none in the block that marks the end
  std::uint32_t slots = 0;
  std::vector<Input> inputs;  ///< by tick, then by slot

  std::uint32_t ticks() const { return static_cast<std::uint32_t>(hashes.size()); }
  /// Of tick `first` + `index`, by slot.
  std::span<const Input> inputsOf(std::uint32_t index) const {
    return std::span(inputs).subspan(std::size_t{index} * slots, slots);
  }
};

/// Reads a recording. Nothing in its bytes is trusted: each block is read when its check sum is right and every value
/// may be what it is.
class RecordingReader {
 public:
  enum class State {
    kReading,
    kComplete,   ///< the mark of the end was read, and nothing follows
    kTruncated,  ///< the bytes end before it
    kDamaged,
  };

  /// Reads the head. `bytes` must outlive the reader.
  explicit RecordingReader(std::span<const std::uint8_t> bytes);

  /// The level; null when the head could not be read or this program cannot play what follows it.
  const std::shared_ptr<const Level>& level() const { return level_; }

  /// The next block, the last one being that which marks the end; then nothing, and `state` says why.
  std::optional<RecordedBlock> next();

  State state() const { return state_; }
  /// What is wrong, and at which byte; empty while nothing is.
  const std::string& fault() const { return fault_; }

 private:
  void readHead();
  std::optional<RecordedBlock> readBody(std::span<const std::uint8_t> bytes, std::size_t offset);
  bool truncatedUnless(std::uint64_t count);
  void damaged(std::size_t offset, std::string_view what);

  std::span<const std::uint8_t> bytes_;
  std::size_t offset_ = 0;
  State state_ = State::kReading;
  std::string fault_;
  std::shared_ptr<const Level> level_;
  std::optional<std::uint32_t> expected_;  // first tick of the next block
};

}  // namespace platon
