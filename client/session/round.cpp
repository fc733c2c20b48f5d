#include "client/session/round.h"

#include <algorithm>

namespace platon {

bool RoundExchange::receive(const ConfirmedTicks& message, std::uint32_t confirmed, Time now) {
  if (message.round != id_) return false;
  clock_.receive(message, now);
  return confirmed >= message.from && confirmed < message.from + message.count;
}

std::optional<std::vector<std::uint8_t>> RoundExchange::receive(const StateChunk& chunk) {
  if (chunk.round != id_ || !state_.add(chunk.total, chunk.offset, chunk.bytes)) return std::nullopt;
  std::vector<std::uint8_t> bytes = state_.bytes();
  state_.clear();
  return bytes;
}

InputsByLocal RoundExchange::choose(std::uint32_t tick, const std::function<InputsByLocal()>& inputs) {
  if (tick < clock_.firstInput()) return {};
  const InputsByLocal chosen = inputs();
  clock_.inputChosen(tick);
  inputSender_.add(tick, chosen);
  return chosen;
}

Round::Round(std::uint32_t id, const std::shared_ptr<const Level>& level, const SlotsByLocal& slots, double lead,
             ConfirmedObserver* observer)
    : exchange_(id, lead),
      prediction_(Game(level), slots),
      hash_(shortHash(prediction_.confirmed().hash())),
      desyncDetector_(id, prediction_.confirmed()),
      observer_(observer) {
  if (observer_ != nullptr) observer_->began(prediction_.confirmed(), prediction_.slot());
}

void Round::setSlots(const SlotsByLocal& slots) {
  for (std::size_t local = 0; local < slots.size(); ++local) {
    if (slots[local] == prediction_.slots()[local]) continue;
    attempts_[local] = Attempt();
    exchange_.forget(local);
  }
  prediction_.setSlots(slots);
}

void Round::receive(const ConfirmedTicks& message, Time now) {
  if (!exchange_.receive(message, prediction_.confirmedTicks(), now)) return;
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
    if (!prediction_.isLocal(slot)) flashes_.observe(slot, prediction_.confirmedTicks(), game.player(slot));
  }
}

void Round::checkHash(std::uint32_t serverHash) {
  const Game& game = prediction_.confirmed();
  hash_ = shortHash(game.hash());
  const bool differs = hash_ != serverHash;
  if (differs && !desyncDetector_.pending()) {
    ++statistics_.desyncs;
    exchange_.sendSoon();  // the server sees the hash in the message and sends its full state
  }
  if (differs)
    desyncDetector_.hashDiffered(game, serverHash);
  else
    desyncDetector_.hashMatched(game);
}

bool Round::receive(const StateChunk& chunk) {
  const std::optional<std::vector<std::uint8_t>> bytes = exchange_.receive(chunk);
  if (bytes) restore(chunk, *bytes);
  return bytes.has_value();
}

void Round::restore(const StateChunk& last, std::span<const std::uint8_t> bytes) {
  const std::optional<FullState> state = decodeFullState(bytes);
  const bool hadTicks = prediction_.confirmedTicks() > 0;
  if (!state || !prediction_.restore(state->game, last.tick, state->held)) return;
  interpolationBuffer_.restart(prediction_.confirmed(), last.tick);
  if (observer_ != nullptr) observer_->began(prediction_.confirmed(), prediction_.slot());
  desync_ = desyncDetector_.resynced(prediction_.confirmed(), prediction_.held());
  sync_ = last.sync;
  hash_ = shortHash(prediction_.confirmed().hash());
  if (hadTicks) ++statistics_.resyncs;
}

void Round::advance(Time now, const Controls& controls) {
  interpolationBuffer_.update(now);
  prediction_.reconcile(now);
  exchange_.update(now, prediction_.predictedTicks());
  const std::function<InputsByLocal()> inputs = [&] { return buttons(controls); };
  // Before the first local input the server keeps applying the held one: a resumed player is present already.
  while (prediction_.mayPredict() && exchange_.isDue(prediction_.predictedTicks())) {
    prediction_.predict(exchange_.choose(prediction_.predictedTicks(), inputs));
    observeLocal();
  }
  workLimit_ = prediction_.work() + kMaxWorkConfirmed;
}

InputsByLocal Round::buttons(const Controls& controls) const {
  InputsByLocal inputs;
  for (std::size_t local = 0; local < inputs.size(); ++local) {
    const std::optional<std::uint32_t>& slot = prediction_.slots()[local];
    if (!slot) continue;
    inputs[local] = controls(prediction_.predicted(), *slot);
    inputs[local].buttons |= Input::kPresent;
    if (attempts_[local].fall.needsRestart()) inputs[local].buttons |= Input::kRestart;
  }
  return inputs;
}

void Round::observeLocal() {
  const Game& game = prediction_.predicted();
  const std::uint32_t ticks = prediction_.predictedTicks();
  teamTime_.observe(ticks, teamOf(game));
  for (std::size_t local = 0; local < attempts_.size(); ++local) {
    const std::optional<std::uint32_t>& slot = prediction_.slots()[local];
    if (!slot || *slot >= game.slots()) continue;
    flashes_.observe(*slot, ticks, game.player(*slot));
    attempts_[local].fall.observe(ticks, game, *slot);
    attempts_[local].time.observe(ticks, game.player(*slot));
  }
}

std::optional<PlayerInputs> Round::takeMessage(Time now) {
  return exchange_.takeMessage(now, {prediction_.confirmedTicks(), hash_, sync_});
}

double Round::predictedFraction() const {
  const PredictionClock& clock = exchange_.clock();
  return clock.running() ? std::clamp(clock.tick() - prediction_.predictedTicks(), 0.0, 1.0) : 1.0;
}

}  // namespace platon
