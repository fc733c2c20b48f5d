#include "server/match/transfer.h"

#include <algorithm>
#include <cassert>

namespace platon {
namespace {

std::span<const std::uint8_t> bytesOf(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

}  // namespace

Transfer::Transfer(const LevelPointer& level) : owner_(level), remaining_(bytesOf(level->text)) {
  LevelChunk chunk;
  chunk.hash = level->hash;
  chunk.total = static_cast<std::uint32_t>(remaining_.size());
  chunk_ = chunk;
}

Transfer::Transfer(std::uint32_t round, std::uint32_t tick, std::uint8_t sync, std::vector<std::uint8_t> bytes) {
  const auto whole = std::make_shared<const std::vector<std::uint8_t>>(std::move(bytes));
  owner_ = whole;
  remaining_ = *whole;
  StateChunk chunk;
  chunk.round = round;
  chunk.tick = tick;
  chunk.sync = sync;
  chunk.total = static_cast<std::uint32_t>(remaining_.size());
  chunk_ = chunk;
}

bool Transfer::isLevel(std::uint64_t hash) const {
  const LevelChunk* chunk = std::get_if<LevelChunk>(&chunk_);
  return chunk && chunk->hash == hash;
}

std::vector<std::uint8_t> Transfer::nextChunk() {
  assert(!done());
  const auto bytes = remaining_.first(std::min(remaining_.size(), kChunkBytes));
  remaining_ = remaining_.subspan(bytes.size());
  return std::visit(
      [bytes](auto& chunk) {
        chunk.bytes.assign(bytes.begin(), bytes.end());
        std::vector<std::uint8_t> message = encode(chunk);
        chunk.offset += static_cast<std::uint32_t>(bytes.size());
        return message;
      },
      chunk_);
}

}  // namespace platon
