#include "client/session/session.h"

#include <algorithm>
#include <string_view>
#include <utility>
#include <variant>

#include "client/netcode/input_clock.h"

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

std::string sentence(std::string_view what, const std::string& reason) {
  return reason.empty() ? std::string(what) : std::string(what) + ": " + reason;
}

}  // namespace

Session::Session(const std::string& name, Moment now, Memory memory)
    : helloAt_(now),
      heardAt_(now),
      token_(memory.token),
      levels_(std::move(memory.levels)),
      pastPrediction_(memory.prediction),
      pastRounds_(memory.rounds) {
  Hello hello;
  hello.name = name;
  hello.token = token_;
  for (const auto& level : levels_) hello.levels.push_back(level->hash);
  send(hello, true);
}

template <class Message>
void Session::send(const Message& message, bool reliable) {
  outgoing_.push_back({encode(message), reliable});
}

std::vector<OutgoingMessage> Session::takeOutgoing() { return std::exchange(outgoing_, {}); }

void Session::end(std::string reason, bool forGood) {
  ending_ = Ending{std::move(reason), forGood};
  if (round_) keep(round_->abandonedDesync());
}

void Session::keep(std::optional<Desync> desync) {
  if (!desync || (desyncAt_ && heardAt_ - *desyncAt_ < kBetweenReports)) return;
  desyncAt_ = heardAt_;
  desync_ = reportOf(std::move(*desync));
}

void Session::leave() {
  if (ending_) return;
  send(Leave{}, true);
  if (round_) keep(round_->abandonedDesync());
}

void Session::lose(std::string reason) {
  if (!ending_) end(std::move(reason), false);
}

void Session::receive(std::span<const std::uint8_t> bytes, Moment now) {
  if (ending_) return;
  heardAt_ = now;
  const std::optional<ToClient> message = decodeToClient(bytes);
  if (!message) return end("the server sent a message that this client does not understand", true);
  std::visit([&](const auto& content) { handle(content, now); }, *message);
}

void Session::update(Moment now, const Controls& controls) {
  if (ending_) return;
  if (welcome_ && now - heardAt_ > kSilence) return end("the server has fallen silent", false);
  if (!round_) return;
  round_->advance(now, controls);
  std::optional<PlayerInputs> report = round_->report(now);
  if (!report) return;
  report->sequence = line_.send(now);
  send(*report, false);
}

void Session::handle(const Welcome& message, Moment now) {
  if (welcome_) return end("the server welcomed this client twice", true);
  welcome_ = message;
  names_.resize(message.maxPlayers);
  lead_ = InputClock::firstLead(now - helloAt_);
  if (!level(message.levelHash)) fetching_ = message.levelHash;  // follows by itself
  startRound(message.round, message.levelHash);
}

// A server that is full, or stops, may have a place later.
void Session::handle(const Refused& message, Moment) {
  end(sentence("the server refused this client", message.reason), message.code != RefusalCode::kFull);
}

void Session::handle(const Bye& message, Moment) {
  end(sentence("the server ended the game", message.reason), message.code != ByeCode::kServerStops);
}

void Session::handle(const Roster& message, Moment) {
  for (const RosterEntry& entry : message.entries) {
    if (entry.slot < names_.size()) names_[entry.slot] = entry.name;
  }
}

void Session::handle(const RoundStart& message, Moment) {
  if (!welcome_) return end("the server started a round before it welcomed this client", true);
  startRound(message.round, message.levelHash);
}

void Session::handle(const RoundEnd& message, Moment) { fetch(message.nextLevelHash); }

void Session::handle(const ConfirmedTicks& message, Moment now) {
  line_.receive(message, now);
  if (round_ && round_->id() == message.round) round_->receive(message, now);
}

void Session::handle(const StateChunk& message, Moment now) {
  if (!round_ || round_->id() != message.round) return;
  if (!state_.add(message.total, message.offset, message.bytes)) return;
  round_->receive(message, state_.bytes(), now);
  keep(round_->takeDesync());
  state_.clear();
}

void Session::handle(const LevelChunk& message, Moment) {
  if (message.hash != fetching_ || !levelText_.add(message.total, message.offset, message.bytes)) return;
  const std::vector<std::uint8_t>& bytes = levelText_.bytes();
  LevelResult result = loadLevel(std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
  fetching_.reset();
  levelText_.clear();
  if (!result.level || result.level->hash != message.hash)
    return end("the server sent a level that is no valid one", true);
  if (levels_.size() == kMaxLevelsKnown) levels_.erase(levels_.begin());
  levels_.push_back(std::move(result.level));
  if (next_) startRound(next_->round, next_->levelHash);
}

std::shared_ptr<const Level> Session::level(std::uint64_t hash) const {
  const auto found =
      std::find_if(levels_.begin(), levels_.end(), [hash](const auto& known) { return known->hash == hash; });
  return found == levels_.end() ? nullptr : *found;
}

void Session::fetch(std::uint64_t levelHash) {
  if (fetching_ == levelHash || level(levelHash)) return;
  fetching_ = levelHash;
  levelText_.clear();
  send(LevelRequest{levelHash}, true);
}

void Session::startRound(std::uint32_t round, std::uint64_t levelHash) {
  closeRound();
  const std::shared_ptr<const Level> known = level(levelHash);
  if (known) {
    next_.reset();
    round_.emplace(round, known, welcome_->slot, lead_);
  } else {
    next_ = RoundStart{round, levelHash};
    fetch(levelHash);
  }
}

void Session::closeRound() {
  if (!round_) return;
  keep(round_->abandonedDesync());
  lead_ = round_->lead();
  pastPrediction_ = predictionStatistics();
  pastRounds_ = roundStatistics();
  round_.reset();
  state_.clear();
}

LinkStatistics Session::reading() const {
  if (!round_ || !round_->clock()) return readingOf(line_, nullptr, 0);
  return readingOf(line_, &*round_->clock(), round_->slack());
}

PredictionStatistics Session::predictionStatistics() const {
  return round_ ? sum(pastPrediction_, round_->prediction().count()) : pastPrediction_;
}

RoundStatistics Session::roundStatistics() const { return round_ ? sum(pastRounds_, round_->count()) : pastRounds_; }

}  // namespace platon
