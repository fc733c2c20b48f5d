#include "client/session/session.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "protocol/label.h"

namespace platon {

namespace {

PredictionStatistics sum(const PredictionStatistics& past, const PredictionStatistics& now) {
  return {past.corrections + now.corrections,
          std::max(past.maxSubunits, now.maxSubunits),
          now.lastSubunits,
          past.missedInputs + now.missedInputs,
          past.mispredicted + now.mispredicted,
          past.confirmedTicks + now.confirmedTicks};
}

RoundStatistics sum(const RoundStatistics& a, const RoundStatistics& b) {
  return {a.desyncs + b.desyncs, a.resyncs + b.resyncs};
}

}  // namespace

Session::Session(const std::string& name, Time now, Memory memory)
    : token_(memory.token),
      observer_(std::move(memory.observer)),
      companions_(std::move(memory.companions)),
      levels_(std::move(memory.levels), std::move(memory.store)),
      dialogue_({kRulesVersion, name, token_, levels_.announced()}, now),
      talk_(now),
      work_(now),
      pastPrediction_(memory.prediction),
      pastRounds_(memory.rounds) {}

void Session::receive(std::span<const std::uint8_t> bytes, Time now) {
  if (ending()) return;
  const std::optional<ToClient> message = dialogue_.receive(bytes, now);
  if (message) std::visit([&](const auto& content) { handle(content, now); }, *message);
  if (ending()) reportLastDesync();
}

void Session::handle(const Welcome& message, Time now) {
  const std::optional<double> lead = dialogue_.begin(message, now);
  if (!lead) return;
  lead_ = *lead;
  talk_.setSlots(message.maxPlayers);
  levels_.expectFirst(message.levelHash, work_);
  slots_ = {message.slot};
  for (std::uint32_t local = 1; local < kMaxLocalPlayers; ++local)
    if (companions_[local]) sendCompanion(local);
  startRound({message.round, message.levelHash});
}

void Session::setCompanion(std::uint32_t local, const std::optional<std::string>& name) {
  if (ending() || companions_[local] == name) return;
  companions_[local] = name;
  if (welcome()) sendCompanion(local);
}

void Session::sendCompanion(std::uint32_t local) {
  const std::optional<std::string>& name = companions_[local];
  dialogue_.send(Companion{local, name.has_value(), name.value_or(std::string())}, true);
}

void Session::handle(const LocalSlots& message, Time now) {
  const auto isOfMatch = [this](const std::optional<std::uint32_t>& slot) {
    return !slot || *slot < welcome()->maxPlayers;
  };
  const bool isValid = welcome() && message.slots[0] == welcome()->slot &&
                       std::all_of(message.slots.begin(), message.slots.end(), isOfMatch);
  if (!isValid) return dialogue_.end({"protocol error: the server gives slots that there are not", true});
  if (!message.reason.empty()) {
    forgetCompanions(message);
    talk_.receive(Notice{message.reason}, now);
  }
  slots_ = message.slots;
  if (round_) round_->setSlots(slots_);
  // Who has left meanwhile, as during an outage, was not told yet to a server that resumes all players.
  for (std::uint32_t local = 1; local < kMaxLocalPlayers; ++local)
    if (slots_[local] && !companions_[local]) sendCompanion(local);
}

// Those that are refused, or removed. Others that have no slot may still get one: their requests are on the way.
void Session::forgetCompanions(const LocalSlots& message) {
  for (std::size_t local = 1; local < slots_.size(); ++local) {
    const bool isMeant = message.local == 0 ? slots_[local].has_value() : message.local == local;
    if (isMeant && !message.slots[local]) companions_[local].reset();
  }
}

void Session::handle(const Refused& message, Time) { dialogue_.end(message); }

void Session::handle(const Bye& message, Time) { dialogue_.end(message); }

void Session::handle(const RoundStart& message, Time) {
  if (!welcome()) return dialogue_.end({"protocol error: RoundStart before Welcome", true});
  startRound(message);
}

// The round begins now, or when its level has been received.
void Session::startRound(RoundStart start) {
  closeRound();
  voteCount_ = VoteCount();
  wishesNext_ = false;
  const std::shared_ptr<const Level> level = levels_.find(start.levelHash, work_);
  if (level) {
    work_.addMessage();
    pendingRound_.reset();
    round_.emplace(start.round, level, slots_, lead_, observer_.get());
  } else {
    pendingRound_ = start;
    requestLevel(start.levelHash);
  }
}

void Session::closeRound() {
  if (!round_) return;
  reportLastDesync();
  lead_ = round_->clock().lead();
  pastPrediction_ = predictionStatistics();
  pastRounds_ = roundStatistics();
  work_.add(round_->prediction().work());
  round_.reset();
}

void Session::requestLevel(std::uint64_t hash) {
  if (!levels_.lacks(hash, work_)) return;
  if (!levels_.request(hash))
    return dialogue_.end({"protocol error: the server names levels that it does not send", true});
  dialogue_.send(LevelRequest{hash}, true);
}

void Session::handle(const LevelChunk& message, Time) {
  const KnownLevels::Receipt receipt = levels_.receive(message, work_);
  if (receipt == KnownLevels::Receipt::kInvalid)
    return dialogue_.end({"protocol error: invalid level from the server", true});
  if (receipt != KnownLevels::Receipt::kLevel || !pendingRound_) return;
  startRound(*pendingRound_);
  prefetch();
}

// Requests the level of the next round, unless the one of this round is still on its way.
void Session::prefetch() {
  if (roundEnd_ && !pendingRound_) requestLevel(roundEnd_->nextLevelHash);
}

void Session::handle(const ConfirmedTicks& message, Time now) {
  dialogue_.measure(message, now);
  if (round_) round_->receive(message, now);
}

void Session::handle(const StateChunk& message, Time) {
  if (!round_ || !round_->receive(message)) return;
  work_.addMessage();
  work_.addBytes(message.total);
  desyncs_.add(round_->takeDesync(), dialogue_.receivedAt());
}

void Session::handle(const VoteCount& message, Time) {
  if (round_ && round_->id() == message.round) voteCount_ = message;
}

void Session::handle(const RoundEnd& message, Time) {
  roundEnd_ = message;
  roundEnd_->nextTitle = visibleLabel(message.nextTitle);
  if (roundEnd_->best) roundEnd_->best->name = visibleLabel(roundEnd_->best->name);
  prefetch();
}

void Session::update(Time now, const Controls& controls) {
  if (ending()) return;
  if (welcome() && now - dialogue_.receivedAt() > kTimeout) return connectionLost("connection timed out");
  if (std::optional<SessionEnding> tooMuch = work_.check(now, round_ ? round_->prediction().work() : 0)) {
    dialogue_.end(std::move(*tooMuch));
    return reportLastDesync();
  }
  if (!round_) return;
  round_->advance(now, controls);
  if (std::optional<PlayerInputs> message = round_->takeMessage(now)) dialogue_.sendInputs(std::move(*message), now);
}

void Session::connectionLost(std::string reason) {
  if (ending()) return;
  dialogue_.end({std::move(reason), false});
  reportLastDesync();
}

// Of a round that ends without a resync.
void Session::reportLastDesync() {
  if (round_) desyncs_.add(round_->endDesync(), dialogue_.receivedAt());
}

void Session::leave() {
  if (ending()) return;
  dialogue_.send(Leave{}, true);
  reportLastDesync();
}

void Session::toggleVote() {
  if (ending() || !round_ || roundEnd()) return;
  wishesNext_ = !wishesNext_;
  dialogue_.send(Vote{round_->id(), wishesNext_}, true);
}

bool Session::say(const Chat& chat, Time now, std::uint32_t local) {
  if (ending() || !welcome() || !talk_.maySay(local, now)) return false;
  dialogue_.send(LocalChat{local, chat}, true);
  return true;
}

const RoundEnd* Session::roundEnd() const {
  return round_ && roundEnd_ && roundEnd_->round == round_->id() ? &*roundEnd_ : nullptr;
}

Session::Memory Session::memory() const {
  return {token_, companions_, levels_.levels(), predictionStatistics(), roundStatistics(), levels_.store(), observer_};
}

LinkStatistics Session::linkStatistics() const { return dialogue_.linkStatistics(round_ ? &round_->clock() : nullptr); }

PredictionStatistics Session::predictionStatistics() const {
  return round_ ? sum(pastPrediction_, round_->prediction().statistics()) : pastPrediction_;
}

RoundStatistics Session::roundStatistics() const {
  return round_ ? sum(pastRounds_, round_->statistics()) : pastRounds_;
}

}  // namespace platon
