#include "protocol/transfer.h"

#include "protocol/bytes.h"
#include "protocol/limits.h"

namespace platon {

bool Assembly::add(std::uint32_t total, std::uint32_t offset, std::span<const std::uint8_t> chunk) {
  if (offset == 0) {
    clear();
    total_ = total;
  }
  const bool inOrder = total == total_ && offset == bytes_.size() && chunk.size() <= total - bytes_.size();
  if (!inOrder || chunk.empty()) {
    clear();
    return false;
  }
  bytes_.insert(bytes_.end(), chunk.begin(), chunk.end());
  return bytes_.size() == total_;
}

void Assembly::clear() {
  bytes_.clear();
  total_ = 0;
}

std::vector<std::uint8_t> encode(const FullState& state) {
  ByteWriter out;
  out.varint(static_cast<std::uint32_t>(state.held.size()));
  for (const Input input : state.held) out.byte(input.buttons);
  out.raw(state.game);
  return out.take();
}

std::optional<FullState> decodeFullState(std::span<const std::uint8_t> bytes) {
  ByteReader in(bytes);
  FullState state;
  const std::uint32_t slots = in.varint();
  if (slots > kMaxPlayers) return std::nullopt;
  for (std::uint32_t slot = 0; slot < slots; ++slot) {
    state.held.push_back(Input{in.byte()});
    if (!isInput(state.held.back())) return std::nullopt;
  }
  if (!in.ok()) return std::nullopt;
  state.game.assign(in.remaining().begin(), in.remaining().end());
  return state;
}

}  // namespace platon
