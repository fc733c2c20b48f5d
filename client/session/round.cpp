#include "client/session/round.h"

#include <algorithm>

namespace platon {

Round::Round(std::uint32_t id, const std::shared_ptr<const Level>& level, std::uint32_t slot, double lead)
    : id_(id),
      prediction_(Game(level), slot),
      clock_(lead),
      hash_(shortHash(prediction_.confirmed().hash())),
      watch_(id, prediction_.confirmed()) {}

void Round::receive(const ConfirmedTicks& message, Moment now) {
  clock_.receive(message, now);
  const std::uint32_t confirmed = prediction_.confirmedTicks();
  if (confirmed < message.from || confirmed >= message.from + message.count) return;
  apply(message);
  view_.arrived(now);
  prediction_.reconcile(now);
  check(message.hash);
}

void Round::apply(const ConfirmedTicks& message) {
  inputs_.assign(prediction_.held().begin(), prediction_.held().end());
  auto change = message.changes.begin();
  while (change != message.changes.end() && change->tick < prediction_.confirmedTicks()) ++change;
  while (prediction_.confirmedTicks() < message.from + message.count) {
    for (; change != message.changes.end() && change->tick == prediction_.confirmedTicks(); ++change) {
      if (change->slot >= inputs_.size()) inputs_.resize(change->slot + 1);
      inputs_[change->slot] = change->input;
    }
    prediction_.confirm(inputs_);
    watch_.advanced(inputs_, prediction_.confirmed());
    view_.advanced(prediction_.confirmed());
    watchOthers();
  }
}

void Round::watchOthers() {
  const Game& game = prediction_.confirmed();
  for (std::uint32_t slot = 0; slot < game.slots(); ++slot) {
    if (slot != prediction_.slot()) flashes_.look(slot, prediction_.confirmedTicks(), game.player(slot));
  }
}

void Round::check(std::uint32_t hash) {
  hash_ = shortHash(prediction_.confirmed().hash());
  const bool matches = hash_ == hash;
  if (!matches && !outOfStep_) {
    ++count_.desyncs;
    schedule_.hurry();
  }
  if (matches)
    watch_.agreed(prediction_.confirmed());
  else
    watch_.differs(prediction_.confirmed(), hash);
  // The server learns it from the hash in the report and answers with the full state.
  outOfStep_ = !matches;
}

void Round::receive(const StateChunk& last, std::span<const std::uint8_t> bytes, Moment now) {
  const std::optional<FullState> state = decodeFullState(bytes);
  const bool hadTicks = prediction_.confirmedTicks() > 0;
  if (!state || !prediction_.restore(state->game, last.tick, state->held)) return;
  view_.restart(prediction_.confirmed(), last.tick);
  prediction_.reconcile(now);
  desync_ = watch_.replaced(prediction_.confirmed(), prediction_.held());
  sync_ = last.sync;
  hash_ = shortHash(prediction_.confirmed().hash());
  outOfStep_ = false;
  if (hadTicks) ++count_.resyncs;
}

void Round::advance(Moment now, const Controls& controls) {
  view_.update(now);
  clock_.update(now, prediction_.predictedTicks());
  while (prediction_.mayPredict() && clock_.reaches(prediction_.predictedTicks())) {
    const std::uint32_t tick = prediction_.predictedTicks();
    // Until the first own input the server goes on with what it holds: who has come back is there already.
    Input own = prediction_.held()[prediction_.slot()];
    if (tick >= clock_.firstInput()) {
      own.buttons = controls(prediction_.predicted(), prediction_.slot()).buttons | Input::kPresent;
      clock_.chose(tick);
      schedule_.chose(own);
    }
    prediction_.predict(own);
    watchOwn();
  }
}

void Round::watchOwn() {
  const std::uint32_t slot = prediction_.slot();
  const Game& game = prediction_.predicted();
  if (slot < game.slots()) flashes_.look(slot, prediction_.predictedTicks(), game.player(slot));
}

std::optional<PlayerInputs> Round::report(Moment now) {
  if (!schedule_.due(now, prediction_.predictedTicks())) return std::nullopt;
  PlayerInputs message{id_, sync_, prediction_.confirmedTicks(), hash_, 0, {}};
  message.first = std::max(message.confirmed, clock_.firstInput());
  for (std::uint32_t tick = message.first; tick < prediction_.predictedTicks(); ++tick) {
    message.inputs.push_back(prediction_.ownInput(tick));
  }
  schedule_.told(now, prediction_.predictedTicks());
  return message;
}

double Round::predictedFraction() const {
  const std::optional<ClockSync>& sync = clock_.sync();
  return sync ? std::clamp(sync->tick() - prediction_.predictedTicks(), 0.0, 1.0) : 1.0;
}

}  // namespace platon
