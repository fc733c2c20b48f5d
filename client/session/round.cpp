#include "client/session/round.h"

#include <algorithm>

namespace platon {

Round::Round(std::uint32_t id, const std::shared_ptr<const Level>& level, std::uint32_t slot, double lead,
             ConfirmedObserver* observer)
    : id_(id),
      prediction_(Game(level), slot),
      clock_(lead),
      inputSender_(id),
      hash_(shortHash(prediction_.confirmed().hash())),
      desyncDetector_(id, prediction_.confirmed()),
      observer_(observer) {
  if (observer_ != nullptr) observer_->began(prediction_.confirmed(), slot);
}

void Round::receive(const ConfirmedTicks& message, Moment now) {
  clock_.receive(message, now);
  const std::uint32_t confirmed = prediction_.confirmedTicks();
  if (confirmed < message.from || confirmed >= message.from + message.count) return;
  const bool complete = applyTicks(message);
  interpolationBuffer_.arrived(now);
  if (complete) return checkHash(message.hash);
  hash_ = shortHash(prediction_.confirmed().hash());
}

// Whether all ticks of the message are confirmed now.
bool Round::applyTicks(const ConfirmedTicks& message) {
  inputs_.assign(prediction_.held().begin(), prediction_.held().end());
  auto change = message.changes.begin();
  while (change != message.changes.end() && change->tick < prediction_.confirmedTicks()) ++change;
  while (prediction_.confirmedTicks() < message.from + message.count) {
    if (prediction_.work() >= workLimit_) return false;
    for (; change != message.changes.end() && change->tick == prediction_.confirmedTicks(); ++change) {
      if (change->slot >= inputs_.size()) inputs_.resize(change->slot + 1);
      inputs_[change->slot] = change->input;
    }
    prediction_.confirm(inputs_);
    desyncDetector_.advanced(inputs_, prediction_.confirmed());
    if (observer_ != nullptr) observer_->advanced(inputs_, prediction_.confirmed());
    interpolationBuffer_.advanced(prediction_.confirmed());
    observeOthers();
  }
  return true;
}

void Round::observeOthers() {
  const Game& game = prediction_.confirmed();
  for (std::uint32_t slot = 0; slot < game.slots(); ++slot) {
    if (slot != prediction_.slot()) flashes_.observe(slot, prediction_.confirmedTicks(), game.player(slot));
  }
}

void Round::checkHash(std::uint32_t serverHash) {
  const Game& game = prediction_.confirmed();
  hash_ = shortHash(game.hash());
  const bool differs = hash_ != serverHash;
  if (differs && !hashDiffered_) {
    ++statistics_.desyncs;
    inputSender_.sendSoon();  // the server sees the hash in the message and sends its full state
  }
  if (differs)
    desyncDetector_.hashDiffered(game, serverHash);
  else
    desyncDetector_.hashMatched(game);
  hashDiffered_ = differs;
}

void Round::receive(const StateChunk& last, std::span<const std::uint8_t> bytes) {
  const std::optional<FullState> state = decodeFullState(bytes);
  const bool hadTicks = prediction_.confirmedTicks() > 0;
  if (!state || !prediction_.restore(state->game, last.tick, state->held)) return;
  interpolationBuffer_.restart(prediction_.confirmed(), last.tick);
  if (observer_ != nullptr) observer_->began(prediction_.confirmed(), prediction_.slot());
  desync_ = desyncDetector_.resynced(prediction_.confirmed(), prediction_.held());
  sync_ = last.sync;
  hash_ = shortHash(prediction_.confirmed().hash());
  hashDiffered_ = false;
  if (hadTicks) ++statistics_.resyncs;
}

void Round::advance(Moment now, const Controls& controls) {
  interpolationBuffer_.update(now);
  prediction_.reconcile(now);
  clock_.update(now, prediction_.predictedTicks());
  while (prediction_.mayPredict() && clock_.reaches(prediction_.predictedTicks())) {
    const std::uint32_t tick = prediction_.predictedTicks();
    // Before the first local input the server keeps applying the held one: a resumed player is present already.
    Input local = prediction_.held()[prediction_.slot()];
    if (tick >= clock_.firstInput()) {
      local.buttons = controls(prediction_.predicted(), prediction_.slot()).buttons | Input::kPresent;
      if (endlessFall_.needsRestart()) local.buttons |= Input::kRestart;
      clock_.inputChosen(tick);
      inputSender_.add(tick, local);
    }
    prediction_.predict(local);
    observeLocal();
  }
  workLimit_ = prediction_.work() + kMaxWorkConfirmed;
}

void Round::observeLocal() {
  const std::uint32_t slot = prediction_.slot();
  const Game& game = prediction_.predicted();
  if (slot >= game.slots()) return;
  const std::uint32_t ticks = prediction_.predictedTicks();
  flashes_.observe(slot, ticks, game.player(slot));
  endlessFall_.observe(ticks, game, slot);
  attemptTime_.observe(ticks, game.player(slot));
}

std::optional<PlayerInputs> Round::takeMessage(Moment now) {
  return inputSender_.takeMessage(now, {prediction_.confirmedTicks(), hash_, sync_});
}

double Round::predictedFraction() const {
  return clock_.running() ? std::clamp(clock_.tick() - prediction_.predictedTicks(), 0.0, 1.0) : 1.0;
}

}  // namespace platon
