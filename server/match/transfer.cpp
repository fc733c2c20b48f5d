#include "server/match/transfer.h"

#include <algorithm>
#include <cassert>
#include <optional>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include "protocol/to_client.h"

namespace platon {
namespace {

std::span<const std::uint8_t> bytesOf(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

}  // namespace

struct Transfer::Messages {
  using Chunk = std::variant<LevelChunk, StateChunk>;

  Messages(Chunk first, std::shared_ptr<const void> keeper, std::span<const std::uint8_t> data)
      : chunk(std::move(first)),
        owner(std::move(keeper)),
        bytes(data),
        encoded((data.size() + kChunkBytes - 1) / kChunkBytes) {
    std::visit([this](auto& head) { head.total = static_cast<std::uint32_t>(bytes.size()); }, chunk);
  }

  const SharedBytes& at(std::size_t index) {
    if (!encoded[index]) encoded[index] = encodeChunk(index * kChunkBytes);
    return *encoded[index];
  }

  std::vector<std::uint8_t> encodeChunk(std::size_t offset) {
    const auto part = bytes.subspan(offset, std::min(bytes.size() - offset, kChunkBytes));
    return std::visit(
        [&](auto& head) {
          head.offset = static_cast<std::uint32_t>(offset);
          head.bytes.assign(part.begin(), part.end());
          return encode(head);
        },
        chunk);
  }

  Chunk chunk;                                      // all but offset and bytes is the same for each
  std::shared_ptr<const void> owner;                // owns `bytes`
  std::span<const std::uint8_t> bytes;              // of all chunks
  std::vector<std::optional<SharedBytes>> encoded;  // by number of the chunk
};

Transfer::Transfer(const LevelPointer& level) {
  LevelChunk chunk;
  chunk.hash = level->hash;
  messages_ = std::make_shared<Messages>(chunk, level, bytesOf(level->text));
}

Transfer::Transfer(std::uint32_t round, std::uint32_t tick, std::uint8_t sync, SharedBytes bytes) {
  StateChunk chunk;
  chunk.round = round;
  chunk.tick = tick;
  chunk.sync = sync;
  const auto owner = std::make_shared<const SharedBytes>(std::move(bytes));
  messages_ = std::make_shared<Messages>(chunk, owner, *owner);
}

bool Transfer::isState() const { return std::holds_alternative<StateChunk>(messages_->chunk); }

bool Transfer::isSameLevel(const Transfer& other) const {
  const auto* mine = std::get_if<LevelChunk>(&messages_->chunk);
  const auto* theirs = std::get_if<LevelChunk>(&other.messages_->chunk);
  return mine && theirs && mine->hash == theirs->hash;
}

bool Transfer::done() const { return next_ == messages_->encoded.size(); }

SharedBytes Transfer::nextChunk() {
  assert(!done());
  return messages_->at(next_++);
}

}  // namespace platon
