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

/// Ticks from one checkpoint to the next.
struct RecordedBlock {
  std::size_t offset = 0;             ///< position in the recording, in bytes
  std::uint32_t firstTick = 0;        ///< ticks the game had advanced before the block; firstTick + ticks() < 2^32
  std::vector<std::uint8_t> state;    ///< state of the game before the block, as Game::save returns it
  std::vector<std::uint64_t> hashes;  ///< hash of the game after each tick; empty in the block that marks the end
  std::uint32_t slots = 0;
  std::vector<Input> inputs;  ///< sorted by tick, then by slot

  std::uint32_t ticks() const { return static_cast<std::uint32_t>(hashes.size()); }
  /// Inputs of the tick with this index in the block, by slot. index < ticks().
  std::span<const Input> inputsOf(std::uint32_t index) const {
    return std::span(inputs).subspan(std::size_t{index} * slots, slots);
  }
};

/// Reads a recording block by block. Trusts nothing: refuses a block whose checksum is wrong or that holds a value out
/// of range.
class RecordingReader {
 public:
  enum class State {
    kReading,
    kComplete,   ///< the block that marks the end has been read, and nothing follows it
    kTruncated,  ///< the bytes end before that block
    kDamaged,    ///< a checksum or a value is wrong, or the recording cannot be played by this program
  };

  /// Reads the head of the recording. `bytes` must outlive the reader.
  explicit RecordingReader(std::span<const std::uint8_t> bytes);

  /// Version of the rules that the game was recorded with; nothing when the head is damaged or cut off.
  const std::optional<std::uint32_t>& rules() const { return rules_; }
  /// Text of the level; empty without rules().
  std::span<const std::uint8_t> levelText() const { return levelText_; }
  /// The level; null when the head is damaged or has another version of the rules.
  const std::shared_ptr<const Level>& level() const { return level_; }

  /// Reads the next block. The last one, without ticks, marks the end. Returns nothing when there are no more or on an
  /// error; state() tells which.
  std::optional<RecordedBlock> next();

  State state() const { return state_; }
  /// Error message with the byte offset; empty without error.
  const std::string& fault() const { return fault_; }

 private:
  void readHead();
  std::optional<RecordedBlock> readBody(std::span<const std::uint8_t> bytes, std::size_t offset);
  bool hasBytes(std::uint64_t count);
  void setDamaged(std::size_t offset, std::string_view what);

  std::span<const std::uint8_t> bytes_;
  std::size_t offset_ = 0;
  State state_ = State::kReading;
  std::string fault_;
  std::optional<std::uint32_t> rules_;
  std::span<const std::uint8_t> levelText_;
  std::shared_ptr<const Level> level_;
  std::optional<std::uint32_t> expectedTick_;  // first tick of the next block
};

}  // namespace platon
