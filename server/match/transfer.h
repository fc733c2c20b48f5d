#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include "server/match/level_rotation.h"
#include "server/match/shared_bytes.h"

namespace platon {

/// A level text or a full state that is sent to one client in chunks. Copies go on independently, but share the
/// messages: each is encoded once, when the first of them needs it.
class Transfer {
 public:
  explicit Transfer(const LevelPointer& level);
  /// `bytes` is the encoded FullState after `tick` ticks of `round`; `sync` is its number in the round.
  Transfer(std::uint32_t round, std::uint32_t tick, std::uint8_t sync, SharedBytes bytes);

  bool isState() const;
  /// Whether both are transfers of the same level.
  bool isSameLevel(const Transfer& other) const;
  bool done() const;
  /// The next message. Must not be called when done.
  SharedBytes nextChunk();

 private:
  struct Messages;

  std::shared_ptr<Messages> messages_;
  std::size_t next_ = 0;
};

}  // namespace platon
