#include "server/match/transfers.h"

#include <algorithm>
#include <cassert>
#include <span>
#include <string>
#include <variant>

#include "protocol/to_client.h"
#include "protocol/transfer.h"
#include "server/match/played_round.h"
#include "server/match/roster.h"

namespace platon {
namespace {

std::span<const std::uint8_t> bytesOf(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

// The next chunks for a client, at most so many. Returns their number.
std::size_t sendTo(ClientId client, ClientTransfers& transfers, std::size_t limit, MatchOutput& output) {
  std::size_t chunks = 0;
  for (; chunks < limit; ++chunks) {
    auto chunk = transfers.nextChunk();
    if (!chunk) break;
    output.send(client, std::move(*chunk));
  }
  return chunks;
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

Transfer TransferCache::level(const LevelPointer& level) {
  const Transfer fresh(level);
  const auto known = std::find_if(levels_.begin(), levels_.end(),
                                  [&fresh](const Transfer& transfer) { return transfer.isSameLevel(fresh); });
  if (known != levels_.end()) return *known;
  if (levels_.size() == kLevels) levels_.erase(levels_.begin());
  return levels_.emplace_back(fresh);
}

Transfer TransferCache::state(std::uint32_t round, const TickHistory& history, const Game& game, std::uint8_t sync) {
  const std::pair at{round, history.end()};
  if (stateAt_ != at) {
    stateAt_ = at;
    state_ = encode(FullState{history.held(), game.save()});
    states_.clear();
  }
  const auto known =
      std::find_if(states_.begin(), states_.end(), [sync](const auto& entry) { return entry.first == sync; });
  if (known != states_.end()) return known->second;
  return states_.emplace_back(sync, Transfer(round, history.end(), sync, state_)).second;
}

void ClientTransfers::startRound() {
  cancelStates();
  levels_ = 0;
  sync_ = 0;
}

void ClientTransfers::resume() {
  transfers_.clear();
  levels_ = 0;
  sync_ = 0;
}

void ClientTransfers::sendLevel(Transfer level) {
  const auto same = [&level](const Transfer& transfer) { return transfer.isSameLevel(level); };
  if (levels_ == kMaxLevelsPerRound || std::any_of(transfers_.begin(), transfers_.end(), same)) return;
  ++levels_;
  transfers_.push_back(std::move(level));
}

void ClientTransfers::sendState(Transfer state, std::uint64_t now) {
  sync_ = nextSync();
  nextStateAt_ = now + kTicksBetweenStates;
  cancelStates();
  transfers_.push_back(std::move(state));
}

void ClientTransfers::cancelStates() {
  std::erase_if(transfers_, [](const Transfer& transfer) { return transfer.isState(); });
}

std::optional<SharedBytes> ClientTransfers::nextChunk() {
  if (transfers_.empty()) return std::nullopt;
  SharedBytes chunk = transfers_.front().nextChunk();
  if (transfers_.front().done()) transfers_.pop_front();
  return chunk;
}

void MatchTransfers::sendLevel(MatchClient& client, const LevelPointer& level) {
  client.transfers().sendLevel(cache_.level(level));
}

void MatchTransfers::sendState(MatchClient& client, const PlayedRound& round, std::uint64_t now) {
  const Transfer state = cache_.state(round.number(), round.history(), round.game(), client.transfers().nextSync());
  client.transfers().sendState(state, now);
  client.ticks().acknowledge(round.history().end());
}

// Clients take turns: if the chunks of one tick do not suffice for all, the next tick continues with the next client.
void MatchTransfers::sendChunks(MatchRoster& roster, const std::function<std::size_t(ClientId)>& room,
                                MatchOutput& output) {
  std::map<ClientId, MatchClient>& clients = roster.connected();
  std::size_t left = kMaxChunksPerTick;
  auto next = clients.lower_bound(next_);
  for (std::size_t visited = 0; visited < clients.size() && left > 0; ++visited) {
    if (next == clients.end()) next = clients.begin();
    auto& [id, client] = *next++;
    if (!client.transfers().hasChunks()) continue;
    const std::size_t limit = std::min({kClientChunksPerTick, left, room ? room(id) : kClientChunksPerTick});
    left -= sendTo(id, client.transfers(), limit, output);
  }
  next_ = next == clients.end() ? 0 : next->first;
}

}  // namespace platon
