#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "platon/game/recorder.h"
#include "platon/game/state_bytes.h"
#include "shared/exact/hash.h"

namespace platon {

/// A recording with correct checksums and blocks that no Recorder would write.
class ForgedRecording {
 public:
  explicit ForgedRecording(const Game& start) : state_(start.save()), bytes_(Recorder(start).takeBytes()) {}

  /// Sets the state of the blocks added from now on.
  void setState(std::vector<std::uint8_t> state) { state_ = std::move(state); }
  /// Adds a block. `runsAndHashes` is what follows the state in its body.
  void addBlock(std::uint32_t first, std::uint16_t ticks, std::uint16_t slots,
                const std::vector<std::uint8_t>& runsAndHashes) {
    StateWriter body;
    body.add(first);
    body.add(ticks);
    body.add(slots);
    body.add(static_cast<std::uint32_t>(state_.size()));
    body.append(state_);
    body.append(runsAndHashes);
    addBody(body.bytes());
  }
  /// Adds a block with any body.
  void addBody(std::span<const std::uint8_t> body) {
    StateWriter block;
    block.add(static_cast<std::uint32_t>(body.size()));
    block.add(~static_cast<std::uint32_t>(body.size()));
    block.append(body);
    block.add(hashOf(body));
    bytes_.insert(bytes_.end(), block.bytes().begin(), block.bytes().end());
  }

  const std::vector<std::uint8_t>& bytes() const { return bytes_; }

 private:
  std::vector<std::uint8_t> state_;
  std::vector<std::uint8_t> bytes_;
};

}  // namespace platon
