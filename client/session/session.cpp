#include "client/session/session.h"

#include <algorithm>
#include <string_view>
#include <utility>
#include <variant>

#include "client/netcode/prediction_clock.h"
#include "protocol/label.h"
#include "protocol/transport/server_address.h"

namespace platon {

namespace {

// Work of starting a round, or of reading a level or a state, and of their bytes.
constexpr std::uint64_t kWorkOfMessage = 64;
constexpr std::size_t kBytesPerWork = 16;
// Work of reading or writing a level that is kept elsewhere, such as on a disk.
constexpr std::uint64_t kWorkOfStore = 4096;
// One longer pause, such as that of a suspended computer, counts as this.
constexpr Moment kMaxSlowUpdate = std::chrono::seconds(1);

// A server with more than a few players sends ticks 30 times a second.
static_assert(kTicksPerSecond / 2 * Prediction::kMaxWorkAhead + 2 * kTicksPerSecond * kMaxPlayers <=
              Session::kMaxWorkPerSecond);

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

std::string withReason(std::string_view what, std::string_view label) {
  const std::string reason = visibleLabel(label);
  return reason.empty() ? std::string(what) : std::string(what) + ": " + reason;
}

}  // namespace

Session::Session(const std::string& name, Moment now, Memory memory)
    : helloAt_(now),
      receivedAt_(now),
      chatBudget_(kChatsPerSecond, kChatBurst, now),
      token_(memory.token),
      levels_(std::move(memory.levels)),
      store_(std::move(memory.store)),
      observer_(std::move(memory.observer)),
      workBudget_(kMaxWorkPerSecond, kMaxWorkPerSecond * toSeconds(kWorkTime), now),
      updatedAt_(now),
      pastPrediction_(memory.prediction),
      pastRounds_(memory.rounds) {
  Hello hello;
  hello.name = name;
  hello.token = token_;
  for (const auto& level : levels_) announced_.push_back(level->hash);
  for (const std::uint64_t hash : store_ ? store_->newest(kMaxLevelsKnown) : std::vector<std::uint64_t>()) {
    const bool isNew = std::find(announced_.begin(), announced_.end(), hash) == announced_.end();
    if (isNew && announced_.size() < kMaxLevelsKnown) announced_.push_back(hash);
  }
  hello.levels = announced_;
  send(hello, true);
}

template <class Message>
void Session::send(const Message& message, bool reliable) {
  outgoing_.push_back({encode(message), reliable});
}

std::vector<OutgoingMessage> Session::takeOutgoing() { return std::exchange(outgoing_, {}); }

void Session::end(std::string reason, bool permanent, const std::string& next) {
  const bool goesOn = isNextServer(next);
  ending_ = Ending{std::move(reason), permanent || goesOn, goesOn ? next : ""};
  if (round_) reportDesync(round_->endDesync());
}

void Session::reportDesync(std::optional<Desync> desync) {
  if (!desync || (reportedAt_ && receivedAt_ - *reportedAt_ < kReportInterval)) return;
  reportedAt_ = receivedAt_;
  desync_ = reportOf(std::move(*desync));
}

const RoundEnd* Session::roundEnd() const {
  return round_ && roundEnd_ && roundEnd_->round == round_->id() ? &*roundEnd_ : nullptr;
}

void Session::toggleVote() {
  if (ending_ || !round_ || roundEnd()) return;
  wishesNext_ = !wishesNext_;
  send(Vote{round_->id(), wishesNext_}, true);
}

bool Session::say(const Chat& chat, Moment now) {
  if (ending_ || !welcome_ || !chatBudget_.take(1, now)) return false;
  send(chat, true);
  return true;
}

void Session::leave() {
  if (ending_) return;
  send(Leave{}, true);
  if (round_) reportDesync(round_->endDesync());
}

void Session::connectionLost(std::string reason) {
  if (!ending_) end(std::move(reason), false);
}

void Session::receive(std::span<const std::uint8_t> bytes, Moment now) {
  if (ending_) return;
  receivedAt_ = now;
  const std::optional<ToClient> message = decodeToClient(bytes);
  if (!message) return end("protocol error: malformed message from the server", true);
  std::visit([&](const auto& content) { handle(content, now); }, *message);
}

void Session::update(Moment now, const Controls& controls) {
  if (ending_) return;
  if (welcome_ && now - receivedAt_ > kTimeout) return end("connection timed out", false);
  checkWork(now);
  if (!round_ || ending_) return;
  round_->advance(now, controls);
  std::optional<PlayerInputs> message = round_->takeMessage(now);
  if (!message) return;
  message->sequence = linkMeter_.nextSequence(now);
  send(*message, false);
}

void Session::checkWork(Moment now) {
  const std::uint64_t demanded = work() - std::exchange(chargedWork_, work());
  const Moment passed = now - std::exchange(updatedAt_, now);
  const bool isSlow = passed > kSlowUpdate && demanded >= kSlowWork;
  slowTime_ = isSlow ? slowTime_ + std::min(passed, kMaxSlowUpdate) : Moment{};
  if (!workBudget_.take(static_cast<double>(demanded), now))
    return end("protocol error: the server demands more computation than a game needs", true);
  if (slowTime_ > kWorkTime) end("this computer is too slow for the game of this server", true);
}

void Session::handle(const Welcome& message, Moment now) {
  if (welcome_) return end("protocol error: second Welcome from the server", true);
  welcome_ = message;
  names_.resize(message.maxPlayers);
  lead_ = PredictionClock::initialLead(now - helloAt_);
  const bool announced = std::find(announced_.begin(), announced_.end(), message.levelHash) != announced_.end();
  if (!announced && !level(message.levelHash)) requestedLevel_ = message.levelHash;  // sent without a request
  startRound(message.round, message.levelHash);
}

// A full server may have a free slot later, and a stopping one may restart, unless it names another one.
void Session::handle(const Refused& message, Moment) {
  end(withReason("the server refused this client", message.reason), message.code != RefusalCode::kFull, message.next);
}

void Session::handle(const Bye& message, Moment) {
  end(withReason("the server ended the game", message.reason), message.code != ByeCode::kServerStops, message.next);
}

void Session::handle(const Notice& message, Moment) {
  std::string text = visibleLabel(message.text);
  if (!text.empty()) notice_ = std::move(text);
}

void Session::handle(const Roster& message, Moment) {
  for (const RosterEntry& entry : message.entries) {
    if (entry.slot < names_.size()) names_[entry.slot] = visibleLabel(entry.name);
  }
}

void Session::handle(const RoundStart& message, Moment) {
  if (!welcome_) return end("protocol error: RoundStart before Welcome", true);
  startRound(message.round, message.levelHash);
}

void Session::handle(const RoundEnd& message, Moment) {
  roundEnd_ = message;
  roundEnd_->nextTitle = visibleLabel(message.nextTitle);
  if (roundEnd_->best) roundEnd_->best->name = visibleLabel(roundEnd_->best->name);
  prefetch();
}

void Session::handle(const VoteCount& message, Moment) {
  if (round_ && round_->id() == message.round) voteCount_ = message;
}

void Session::handle(const PlayerChat& message, Moment) {
  const PlayerChat said{message.slot, {visibleLabel(message.chat.text), message.chat.emote}};
  if (!isChat(said.chat)) return;
  if (chats_.size() == kMaxChats) chats_.erase(chats_.begin());
  chats_.push_back(said);
}

void Session::handle(const RoundTrips& message, Moment now) { roundTrips_.receive(message, now); }

std::optional<std::uint32_t> Session::roundTripMs(std::uint32_t slot, Moment now) const {
  const bool isFree = slot >= names_.size() || names_[slot].empty();
  return isFree ? std::nullopt : roundTrips_.of(slot, now);
}

// Requests the level of the next round, unless the one of this round is still on its way.
void Session::prefetch() {
  if (roundEnd_ && !pendingRound_) requestLevel(roundEnd_->nextLevelHash);
}

void Session::handle(const ConfirmedTicks& message, Moment now) {
  linkMeter_.receive(message, now);
  if (round_ && round_->id() == message.round) round_->receive(message, now);
}

void Session::handle(const StateChunk& message, Moment) {
  if (!round_ || round_->id() != message.round) return;
  if (!state_.add(message.total, message.offset, message.bytes)) return;
  round_->receive(message, state_.bytes());
  pastWork_ += kWorkOfMessage + state_.bytes().size() / kBytesPerWork;
  reportDesync(round_->takeDesync());
  state_.clear();
}

void Session::handle(const LevelChunk& message, Moment) {
  if (message.hash != requestedLevel_ || !levelText_.add(message.total, message.offset, message.bytes)) return;
  const std::vector<std::uint8_t>& bytes = levelText_.bytes();
  LevelResult result = loadLevel(std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
  pastWork_ += kWorkOfMessage + bytes.size() / kBytesPerWork;
  requestedLevel_.reset();
  levelText_.clear();
  unanswered_ = 0;
  if (!result.level || result.level->hash != message.hash)
    return end("protocol error: invalid level from the server", true);
  if (store_) {
    pastWork_ += kWorkOfStore;
    store_->keep(*result.level);
  }
  remember(std::move(result.level));
  if (!pendingRound_) return;
  startRound(pendingRound_->round, pendingRound_->levelHash);
  prefetch();
}

void Session::remember(std::shared_ptr<const Level> level) {
  if (levels_.size() == kMaxLevelsKnown) levels_.erase(levels_.begin());
  levels_.push_back(std::move(level));
}

// Null if the level must come from the server.
std::shared_ptr<const Level> Session::level(std::uint64_t hash) {
  const auto found =
      std::find_if(levels_.begin(), levels_.end(), [hash](const auto& known) { return known->hash == hash; });
  if (found != levels_.end()) return *found;
  std::shared_ptr<const Level> stored = store_ ? store_->load(hash) : nullptr;
  if (stored) {
    pastWork_ += kWorkOfStore + stored->text.size() / kBytesPerWork;
    remember(stored);
  }
  return stored;
}

void Session::requestLevel(std::uint64_t levelHash) {
  if (requestedLevel_ == levelHash || level(levelHash)) return;
  if (++unanswered_ > kMaxUnansweredRequests)
    return end("protocol error: the server names levels that it does not send", true);
  requestedLevel_ = levelHash;
  levelText_.clear();
  send(LevelRequest{levelHash}, true);
}

void Session::startRound(std::uint32_t round, std::uint64_t levelHash) {
  closeRound();
  voteCount_ = VoteCount();
  wishesNext_ = false;
  const std::shared_ptr<const Level> known = level(levelHash);
  if (known) {
    pastWork_ += kWorkOfMessage;
    pendingRound_.reset();
    round_.emplace(round, known, welcome_->slot, lead_, observer_.get());
  } else {
    pendingRound_ = RoundStart{round, levelHash};
    requestLevel(levelHash);
  }
}

void Session::closeRound() {
  if (!round_) return;
  reportDesync(round_->endDesync());
  lead_ = round_->clock().lead();
  pastPrediction_ = predictionStatistics();
  pastRounds_ = roundStatistics();
  pastWork_ = work();
  round_.reset();
  state_.clear();
}

LinkStatistics Session::linkStatistics() const { return linkMeter_.statistics(round_ ? &round_->clock() : nullptr); }

PredictionStatistics Session::predictionStatistics() const {
  return round_ ? sum(pastPrediction_, round_->prediction().statistics()) : pastPrediction_;
}

RoundStatistics Session::roundStatistics() const {
  return round_ ? sum(pastRounds_, round_->statistics()) : pastRounds_;
}

}  // namespace platon
