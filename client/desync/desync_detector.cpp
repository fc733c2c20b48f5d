#include "client/desync/desync_detector.h"

#include <algorithm>
#include <utility>

#include "protocol/limits.h"

namespace platon {

RecentRecording::RecentRecording(const Game& start)
    : recorder_(start, kTicksBetweenCheckpoints), header_(recorder_.takeBytes()) {}

void RecentRecording::record(std::span<const Input> inputs, const Game& game) {
  recorder_.record(inputs, game);
  std::vector<std::uint8_t> block = recorder_.takeBytes();
  if (block.empty()) return;
  blockBytes_ += block.size();
  blocks_.push_back(std::move(block));
  for (; blockBytes_ > kMaxBytes && blocks_.size() > 1; blocks_.pop_front()) blockBytes_ -= blocks_.front().size();
}

std::vector<std::uint8_t> RecentRecording::finish(const Game& game) {
  recorder_.finish(game);
  blocks_.push_back(recorder_.takeBytes());
  std::vector<std::uint8_t> whole = header_;
  for (const auto& block : blocks_) whole.insert(whole.end(), block.begin(), block.end());
  return whole;
}

DesyncDetector::DesyncDetector(std::uint32_t round, const Game& start)
    : round_(round), matchedAt_(start.tick()), recording_(start) {}

void DesyncDetector::advanced(std::span<const Input> inputs, const Game& game) {
  recording_.record(inputs, game);
  if (!pending_) return;
  states_.push_back(game);
  if (states_.size() > kMaxStates) states_.pop_front();
}

void DesyncDetector::hashMatched(const Game& game) {
  matchedAt_ = game.tick();
  pending_.reset();
  states_.clear();
}

void DesyncDetector::hashDiffered(const Game& game, std::uint32_t serverHash) {
  if (pending_) return;
  pending_ = Pending{game.tick(), shortHash(game.hash()), serverHash};
  states_.push_back(game);
}

std::optional<Desync> DesyncDetector::resynced(const Game& server, std::span<const Input> held) {
  std::optional<Desync> found;
  if (pending_) {
    const Game* const same = stateAt(server.tick());
    found = makeDesync(same != nullptr ? *same : states_.back());
    // The server's state contains the inputs of its last tick.
    if (found->client.tick() + 1 == server.tick()) found->client.advance(held);
    found->server = server;
  }
  *this = DesyncDetector(round_, server);
  return found;
}

std::optional<Desync> DesyncDetector::ended() {
  if (!pending_) return std::nullopt;
  return makeDesync(states_.back());
}

Desync DesyncDetector::makeDesync(Game client) {
  std::vector<std::uint8_t> recording = recording_.finish(states_.back());
  return {
      round_,       matchedAt_,          pending_->tick, pending_->clientHash, pending_->serverHash, std::move(client),
      std::nullopt, std::move(recording)};
}

const Game* DesyncDetector::stateAt(std::uint32_t tick) const {
  const auto found =
      std::find_if(states_.begin(), states_.end(), [tick](const Game& game) { return game.tick() == tick; });
  return found == states_.end() ? nullptr : &*found;
}

}  // namespace platon
