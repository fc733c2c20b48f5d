#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "platon/game/input.h"

namespace platon {

/// Joins the chunks of a level text or a full state. A chunk out of order discards all chunks received so far; a chunk
/// at offset 0 starts over.
class Assembly {
 public:
  /// Adds a chunk of a text or state of `total` bytes. Returns true if it is the last one. Memory grows with the bytes
  /// received, not with `total`.
  bool add(std::uint32_t total, std::uint32_t offset, std::span<const std::uint8_t> chunk);

  /// The bytes joined so far.
  const std::vector<std::uint8_t>& bytes() const { return bytes_; }
  void clear();

 private:
  std::vector<std::uint8_t> bytes_;
  std::uint32_t total_ = 0;
};

/// All that a client needs to join a round in progress: the payload of the `StateChunk` messages.
struct FullState {
  std::vector<Input> held;         ///< input of each slot in the last tick; later changes are relative to it
  std::vector<std::uint8_t> game;  ///< result of `Game::save`

  friend bool operator==(const FullState&, const FullState&) = default;
};

std::vector<std::uint8_t> encode(const FullState& state);
/// Returns nothing if the bytes are malformed. `game` is not checked: `Game::restore` does that.
std::optional<FullState> decodeFullState(std::span<const std::uint8_t> bytes);

}  // namespace platon
