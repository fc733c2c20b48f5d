#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <variant>
#include <vector>

#include "protocol/to_client.h"
#include "server/match/level_rotation.h"

namespace platon {

/// A level text or a full state that is sent to one client in chunks.
class Transfer {
 public:
  explicit Transfer(const LevelPointer& level);
  /// `bytes` is the encoded FullState after `tick` ticks of `round`; `sync` is its number in the round.
  Transfer(std::uint32_t round, std::uint32_t tick, std::uint8_t sync, std::vector<std::uint8_t> bytes);

  bool isState() const { return std::holds_alternative<StateChunk>(chunk_); }
  /// Whether this is the level with this hash.
  bool isLevel(std::uint64_t hash) const;
  bool done() const { return remaining_.empty(); }
  /// The next message. Must not be called when done.
  std::vector<std::uint8_t> nextChunk();

 private:
  std::variant<LevelChunk, StateChunk> chunk_;  // the next chunk, without its bytes
  std::shared_ptr<const void> owner_;           // owns the bytes of remaining_
  std::span<const std::uint8_t> remaining_;
};

}  // namespace platon
