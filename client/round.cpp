#include "client/round.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace platon {

namespace {

constexpr std::uint32_t kTicksBetweenReports = 4;
// Between two calls: a quarter of a second. No line is to blame, and nobody shall be ahead by as much for ever after.
constexpr std::uint32_t kHiccupTicks = 15;
constexpr std::uint32_t kNotJudged = UINT32_MAX;
constexpr std::uint32_t kRepeats = 2;   // of a change, each a tick after the one before
constexpr Moment kIdleReport = std::chrono::milliseconds(80);

}  // namespace

Round::Round(std::uint32_t id, const std::shared_ptr<const Level>& level, std::uint32_t slot, double lead)
    : id_(id),
      prediction_(Game(level), slot),
      lead_(lead),
      hash_(shortHash(prediction_.confirmed().hash())),
      watch_(id, prediction_.confirmed()) {}

void Round::receive(const ConfirmedTicks& message, Moment now) {
  const std::uint32_t newest = message.from + message.count;
  // While catching up a message does not tell how far the server is.
  if (message.count < kMaxTicksPerMessage) setClock(newest, now);
  if (clock_ && message.line && message.line->slack) judge(*message.line->slack);
  if (clock_ && clock_->reported()) lead_ = clock_->tick() - newest;
  const std::uint32_t confirmed = prediction_.confirmedTicks();
  if (confirmed < message.from || confirmed >= newest) return;
  apply(message);
  view_.arrived(now);
  prediction_.reconcile(now);
  check(message.hash);
}

void Round::judge(const SlackReport& report) {
  slack_ = report.slack;
  // Of ticks that were predicted and sent together, the oldest must be in time.
  const std::uint32_t older = burst_[report.tick % burst_.size()];
  if (older <= report.tick) clock_->report(report.tick - older, report.slack - static_cast<std::int32_t>(older));
}

// The first message may have been a late one: until the server reports, the earliest of those that came counts.
void Round::setClock(std::uint32_t newest, Moment now) {
  if (clock_) return clock_->expect(newest + lead_);
  clock_.emplace(newest + lead_, now);
  firstInput_ = static_cast<std::uint32_t>(std::max(0.0, std::floor(clock_->tick())));
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
    ++count_.hashMismatches;
    tellMismatch_ = true;
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
  mismatch_ = watch_.replaced(prediction_.confirmed(), prediction_.held());
  sync_ = last.sync;
  hash_ = shortHash(prediction_.confirmed().hash());
  outOfStep_ = false;
  if (hadTicks) ++count_.resyncs;
}

void Round::advance(Moment now, const Controls& controls) {
  view_.update(now);
  if (!clock_) return;
  const double shown = clock_->tick();
  clock_->update(now);
  const std::uint32_t before = std::max(prediction_.predictedTicks(), firstInput_);
  const bool hiccup = clock_->tick() - shown >= kHiccupTicks;
  while (prediction_.predictedTicks() + 1 <= clock_->tick()) {
    Input own;
    const std::uint32_t tick = prediction_.predictedTicks();
    if (tick >= firstInput_) {
      own.buttons = controls(prediction_.predicted(), prediction_.slot()).buttons | Input::kPresent;
      burst_[tick % burst_.size()] = hiccup ? kNotJudged : tick - before;
    }
    if (!prediction_.predict(own)) break;
    const std::uint32_t slot = prediction_.slot();
    const Game& game = prediction_.predicted();
    if (slot < game.slots()) flashes_.look(slot, prediction_.predictedTicks(), game.player(slot));
  }
}

bool Round::changedSinceReport() const {
  for (std::uint32_t tick = std::max(sentTicks_, firstInput_); tick < prediction_.predictedTicks(); ++tick) {
    if (tick == firstInput_ || prediction_.ownInput(tick) != prediction_.ownInput(tick - 1)) return true;
  }
  return false;
}

bool Round::worthSending(Moment now) const {
  if (!sentAt_ || now - *sentAt_ >= kIdleReport || tellMismatch_) return true;
  const std::uint32_t ticks = prediction_.predictedTicks();
  if (ticks <= std::max(sentTicks_, firstInput_)) return false;
  return repeats_ > 0 || ticks - sentTicks_ >= kTicksBetweenReports || changedSinceReport();
}

std::optional<PlayerInputs> Round::report(Moment now) {
  if (!worthSending(now)) return std::nullopt;
  PlayerInputs message{id_, sync_, prediction_.confirmedTicks(), hash_, 0, {}};
  message.first = std::max(message.confirmed, firstInput_);
  for (std::uint32_t tick = message.first; tick < prediction_.predictedTicks(); ++tick) {
    message.inputs.push_back(prediction_.ownInput(tick));
  }
  repeats_ = changedSinceReport() ? kRepeats : repeats_ - std::min(repeats_, 1u);
  tellMismatch_ = false;
  sentAt_ = now;
  sentTicks_ = prediction_.predictedTicks();
  return message;
}

double Round::predictedFraction() const {
  return clock_ ? std::clamp(clock_->tick() - prediction_.predictedTicks(), 0.0, 1.0) : 1.0;
}

}  // namespace platon
