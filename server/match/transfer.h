#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <variant>
#include <vector>

#include "protocol/to_client.h"
#include "server/match/level_rotation.h"

namespace platon {

/// A level text or a full state on its way to one client, piece by piece.
class Transfer {
 public:
  explicit Transfer(const LevelPointer& level);
  /// `bytes` is an encoded FullState after `tick` ticks of `round`.
  Transfer(std::uint32_t round, std::uint32_t tick, std::uint8_t sync, std::vector<std::uint8_t> bytes);

  bool isState() const { return std::holds_alternative<StateChunk>(chunk_); }
  /// Whether this is the level with that hash.
  bool isLevel(std::uint64_t hash) const;
  bool done() const { return rest_.empty(); }
  /// The next message; not when done.
  std::vector<std::uint8_t> next();

 private:
  std::variant<LevelChunk, StateChunk> chunk_;  // the next piece, but for its bytes
  std::shared_ptr<const void> owner_;           // of what rest_ looks at
  std::span<const std::uint8_t> rest_;
};

}  // namespace platon
