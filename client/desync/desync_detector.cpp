#include "client/desync/desync_detector.h"

#include <algorithm>
#include <utility>

#include "protocol/limits.h"

namespace platon {

DesyncDetector::DesyncDetector(std::uint32_t round, const Game& start)
    : round_(round), agreedAt_(start.tick()), recording_(start) {}

void DesyncDetector::advanced(std::span<const Input> inputs, const Game& game) {
  recording_.record(inputs, game);
  if (!wrong_) return;
  states_.push_back(game);
  if (states_.size() > kMaxStates) states_.pop_front();
}

void DesyncDetector::agreed(const Game& game) {
  agreedAt_ = game.tick();
  wrong_.reset();
  states_.clear();
}

void DesyncDetector::differs(const Game& game, std::uint32_t serverHash) {
  if (wrong_) return;
  wrong_ = Wrong{game.tick(), shortHash(game.hash()), serverHash};
  states_.push_back(game);
}

std::optional<Desync> DesyncDetector::replaced(const Game& server, std::span<const Input> held) {
  std::optional<Desync> found;
  if (wrong_) {
    const Game* const same = stateAfter(server.tick());
    found = desync(same != nullptr ? *same : states_.back());
    const std::uint32_t missing = server.tick() - std::min(found->own.tick(), server.tick());
    // The inputs of the last of them came with the state.
    if (missing > 0 && missing <= kMaxStates) {
      found->guessedTicks = missing - 1;
      for (std::uint32_t i = 0; i < missing; ++i) found->own.advance(held);
    }
    found->server = server;
  }
  *this = DesyncDetector(round_, server);
  return found;
}

std::optional<Desync> DesyncDetector::abandoned() {
  if (!wrong_) return std::nullopt;
  return desync(states_.back());
}

Desync DesyncDetector::desync(Game own) {
  std::vector<std::uint8_t> recording = recording_.finish(states_.back());
  return {round_,         agreedAt_, wrong_->tick, wrong_->ownHash,     wrong_->serverHash,
          std::move(own), 0,         std::nullopt, std::move(recording)};
}

const Game* DesyncDetector::stateAfter(std::uint32_t tick) const {
  const auto found =
      std::find_if(states_.begin(), states_.end(), [tick](const Game& game) { return game.tick() == tick; });
  return found == states_.end() ? nullptr : &*found;
}

}  // namespace platon
