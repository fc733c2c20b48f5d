// How the rounds of a match end and follow each other.
#include <algorithm>

#include "protocol/label.h"
#include "server/match/match.h"

namespace platon {
namespace {

static_assert(Match::kPauseTicks <= kMaxPauseTicks);

std::string shownTitle(const Level& level) {
  const std::string title = visibleLabel(level.title);
  return title.empty() ? std::string(nameOf(level.solid)) : title;
}

}  // namespace

void Match::setLevels(std::vector<LevelPointer> levels) {
  rotation_.replace(std::move(levels));
  tellNext();
}

void Match::updateLevels(std::vector<LevelPointer> levels) {
  rotation_.update(std::move(levels));
  tellNext();
}

// In the pause, tells all players how the round has ended and what comes next.
void Match::tellNext() {
  if (!overAt_) return;
  toldNext_ = rotation_.next(players());
  toldPause_ = pauseTicks();
  sendAll(encode(roundEnd()));
}

void Match::handle(ClientId client, const Vote& vote) {
  const auto found = players_.find(client);
  if (found != players_.end() && vote.round == round_ && !overAt_) found->second.vote(vote.next, now_);
}

// Ends the round when it is over, and starts the next one after the pause.
void Match::finishRound() {
  noteFinishes();
  if (!finishedAt_ && someoneHasFinished()) finishedAt_ = now_;
  if (overAt_) {
    // Players who have come or left decide whether a level for several players is next, and whether it is waited for.
    // It comes only once it was told.
    if (rotation_.next(players()) != toldNext_ || pauseTicks() != toldPause_) return tellNext();
    if (!waits() && !draining_ && pauseIsOver()) startNextRound();
    return;
  }
  const VoteCount votes = countVotes();
  if (roundOver())
    endRound(game_.ticksLeft() == 0 ? "time" : "finished");
  else if (votePasses(votes))
    endRound("vote");
  else if (const std::optional<VoteCount> count = voteNotices_.take(votes, now_))
    sendAll(encode(*count));
}

// What attempts that run in this tick are worth.
void Match::noteTick() {
  if (!countsTimes_) uncountedAt_ = game_.tick();
  if (settings_.keepsTimesOfOne && players_.size() > std::max(1u, game_.level().players)) sharedAt_ = game_.tick();
}

// Offers the times of those who have reached the goal in this tick. In the pause, a new best time is told at once.
void Match::noteFinishes() {
  noteTick();
  bool isBest = false;
  for (std::uint32_t slot = 0; bestTimes_ && slot < game_.slots(); ++slot) {
    const PlayerState& player = game_.player(slot);
    if (!arrives(slot) || player.startedAt <= uncountedAt_ || names_.isFree(slot)) continue;
    const BestTime time{game_.tick() - player.startedAt + 1, names_.shown(slot)};
    if (time.ticks > kMaxBestTicks) continue;
    isBest = bestTimes_->offer(rotation_.current()->hash, time, player.startedAt > sharedAt_) || isBest;
  }
  arrived_.assign(game_.slots(), false);
  for (std::uint32_t slot = 0; slot < game_.slots(); ++slot) arrived_[slot] = game_.player(slot).arrived != 0;
  bestIsNew_ = bestIsNew_ || isBest;
  if (isBest) tellNext();
}

// Whether a player has reached the goal in the last tick.
bool Match::arrives(std::uint32_t slot) const {
  return game_.player(slot).arrived != 0 && (slot >= arrived_.size() || !arrived_[slot]);
}

// Connected players that are active.
VoteCount Match::countVotes() {
  VoteCount count{round_, 0, 0};
  for (auto& [client, player] : players_) {
    if (!player.isActive(now_)) continue;
    ++count.voters;
    count.votes += player.wishesNext(now_) ? 1 : 0;
  }
  return count;
}

// The game is over when all players present have finished. A match does not wait that long for players that are
// inactive or disconnected: it is enough that one player has finished and that it awaits no other. Nor does it end when
// the time is up while it waits for a player who is alone.
bool Match::roundOver() const {
  if (game_.over() && !(waits() && game_.ticksLeft() == 0)) return true;
  return finishedAt_ &&
         std::none_of(players_.begin(), players_.end(), [this](const auto& entry) { return awaits(entry.second); }) &&
         std::none_of(disconnected_.begin(), disconnected_.end(), [this](const Disconnected& entry) {
           return now_ - entry.since < kAwaitTicks && awaits(entry.player);
         });
}

bool Match::someoneHasFinished() const {
  for (std::uint32_t slot = 0; slot < game_.slots(); ++slot) {
    if (game_.player(slot).finished()) return true;
  }
  return false;
}

// Whether the player is in the game, has not finished, and is active. In a level for several players, one may have
// stood on a plate for the other without a key; then it has as much time as if it had changed a button at the first
// finish.
bool Match::awaits(const MatchPlayer& player) const {
  if (player.slot() >= game_.slots()) return false;
  const PlayerState& state = game_.player(player.slot());
  const bool mayHaveHelped = game_.level().players > 1 && now_ - *finishedAt_ < MatchPlayer::kActiveTicks;
  return state.present != 0 && !state.finished() && (player.isActive(now_) || mayHaveHelped);
}

void Match::endRound(const std::string& cause) {
  overAt_ = history_.end();
  tellNext();
  if (draining_) say(draining_->notice);
  events_.push_back({MatchEvent::Kind::kRoundEnd, 0, 0, cause, *overAt_});
}

// Call only when the round is over.
RoundEnd Match::roundEnd() const {
  const Level& next = *rotation_.next(players());
  RoundEnd message{round_, *overAt_, next.hash, shownTitle(next), pauseTicks(), {}};
  const auto best = bestTimes_ ? bestTimes_->best(rotation_.current()->hash) : std::nullopt;
  if (best) message.best = LevelBest{best->ticks, best->name, bestIsNew_};
  return message;
}

bool Match::endRoundNow() {
  if (overAt_) return false;
  if (idle())
    startNextRound();
  else
    endRound("operator");
  return true;
}

void Match::startNextRound() {
  rotation_.advance(players());
  restartRound();
}

void Match::restartRound() {
  startRound();
  sendAll(encode(RoundStart{round_, rotation_.current()->hash}));
}

void Match::startRound() {
  recorder_.finish(game_);
  ++round_;
  game_ = Game(rotation_.current());
  history_ = TickHistory(round_, shortHash(game_.hash()));
  overAt_.reset();
  finishedAt_.reset();
  bestIsNew_ = false;
  uncountedAt_ = sharedAt_ = 0;
  arrived_.clear();
  voteNotices_.startRound();
  for (auto& [client, player] : players_) player.startRound();
  for (Disconnected& entry : disconnected_) entry.player.startRound();
  addEvent(MatchEvent::Kind::kRoundStart, 0, 0, rotation_.current()->title);
}

}  // namespace platon
