#include "server/match/rounds.h"

#include <algorithm>
#include <utility>

#include "protocol/label.h"
#include "server/match/roster.h"

namespace platon {
namespace {

static_assert(MatchRounds::kPauseTicks <= kMaxPauseTicks);

std::string shownTitle(const Level& level) {
  const std::string title = visibleLabel(level.title);
  return title.empty() ? std::string(nameOf(level.solid)) : title;
}

}  // namespace

MatchRounds::MatchRounds(LevelRotation rotation, const MatchSettings& settings, BestTimeKeeper* keeper,
                         MatchOutput& output)
    : rotation_(std::move(rotation)),
      played_(rotation_.current(), settings.record),
      times_(keeper, settings.keepsTimesOfOne),
      waitsForOne_(settings.waitsForOne) {
  noteStart(output);
}

void MatchRounds::noteStart(MatchOutput& output) const {
  output.add(MatchEvent::Kind::kRoundStart, 0, 0, level()->title);
}

void MatchRounds::start(MatchRoster& roster, MatchOutput& output) {
  played_.start(level());
  times_.startRound();
  overAt_.reset();
  finishedAt_.reset();
  voteNotices_.startRound();
  roster.startRound();
  noteStart(output);
  roster.sendAll(encode(RoundStart{played_.number(), level()->hash}), output);
}

void MatchRounds::startNext(MatchRoster& roster, MatchOutput& output) {
  rotation_.advance(roster.players());
  start(roster, output);
}

void MatchRounds::awaitPlayer(MatchRoster& roster, MatchOutput& output) {
  if (roster.idle() && played_.ticks() > 0) {
    if (level()->players > 1) rotation_.advance(1);  // the players for whom it was chosen have left
    start(roster, output);
  } else if (completesLevel(roster)) {
    start(roster, output);
  }
}

// Whether one more player is what a round waits for, in which too few played a level for several: its clock and the
// time that they share have run for nothing.
bool MatchRounds::completesLevel(const MatchRoster& roster) const {
  const std::size_t players = roster.players();
  return waitsForOne_ && !overAt_ && players >= 1 && players + 1 == level()->players;
}

// Those who play at one machine need no time limit to wait for each other.
bool MatchRounds::waits(const MatchRoster& roster) const { return waitsForOne_ && roster.connected().size() <= 1; }

void MatchRounds::proceed(MatchRoster& roster, std::uint64_t now, MatchOutput& output) {
  const bool bestIsNew = times_.note(played_.game(), roster.names(), roster.players());
  if (bestIsNew) tellNext(roster, output);
  if (!finishedAt_ && someoneHasFinished()) finishedAt_ = now;
  if (overAt_) return pause(roster, output);
  const VoteCount votes = countVotes(roster, now);
  if (isOver(roster, now))
    end(played_.game().ticksLeft() == 0 ? "time" : "finished", roster, output);
  else if (votePasses(votes))
    end("vote", roster, output);
  else if (const std::optional<VoteCount> count = voteNotices_.take(votes, now))
    roster.sendAll(encode(*count), output);
}

// Players who have come or left decide whether a level for several players is next, and whether it is waited for. It
// comes only once it was told.
void MatchRounds::pause(MatchRoster& roster, MatchOutput& output) {
  const bool isTold = rotation_.next(roster.players()) == toldNext_ && pauseTicks(roster) == toldPause_;
  if (!isTold) return tellNext(roster, output);
  if (!waits(roster) && !drain_ && pauseIsOver()) startNext(roster, output);
}

bool MatchRounds::someoneHasFinished() const {
  const Game& game = played_.game();
  for (std::uint32_t slot = 0; slot < game.slots(); ++slot) {
    if (game.player(slot).finished()) return true;
  }
  return false;
}

// The game is over when all players present have finished. A match does not wait that long for players that are
// inactive or disconnected: it is enough that one player has finished and that it awaits no other. Nor does it end when
// the time is up while it waits for those at one machine.
bool MatchRounds::isOver(const MatchRoster& roster, std::uint64_t now) const {
  const Game& game = played_.game();
  if (game.over() && !(waits(roster) && game.ticksLeft() == 0)) return true;
  const auto& connected = roster.connected();
  const auto& disconnected = roster.disconnected();
  return finishedAt_ &&
         std::none_of(connected.begin(), connected.end(),
                      [&](const auto& entry) { return awaitsAnyOf(entry.second, now); }) &&
         std::none_of(disconnected.begin(), disconnected.end(), [&](const MatchRoster::Disconnected& entry) {
           return now - entry.since < kAwaitTicks && awaitsAnyOf(entry.client, now);
         });
}

bool MatchRounds::awaitsAnyOf(const MatchClient& client, std::uint64_t now) const {
  return std::any_of(client.players().begin(), client.players().end(),
                     [&](const auto& entry) { return awaits(entry.second, now); });
}

// Whether the player is in the game, has not finished, and is active. In a level for several players, one may have
// stood on a plate for the other without a key; then it has as much time as if it had changed a button at the first
// finish.
bool MatchRounds::awaits(const MatchPlayer& player, std::uint64_t now) const {
  const Game& game = played_.game();
  if (player.slot() >= game.slots()) return false;
  const PlayerState& state = game.player(player.slot());
  const bool mayHaveHelped = game.level().players > 1 && now - *finishedAt_ < MatchPlayer::kActiveTicks;
  return state.present != 0 && !state.finished() && (player.isActive(now) || mayHaveHelped);
}

void MatchRounds::vote(MatchClient& client, const Vote& vote, std::uint64_t now) {
  if (vote.round == played_.number() && !overAt_) client.vote(vote.next, now);
}

// Connected players that are active. A client votes for all of them that it has.
VoteCount MatchRounds::countVotes(MatchRoster& roster, std::uint64_t now) const {
  VoteCount count{played_.number(), 0, 0};
  for (auto& [id, client] : roster.connected()) {
    const std::uint32_t voters = client.activePlayers(now);
    count.voters += voters;
    count.votes += client.wishesNext(now) ? voters : 0;
  }
  return count;
}

bool MatchRounds::endNow(MatchRoster& roster, MatchOutput& output) {
  if (overAt_) return false;
  if (roster.idle())
    startNext(roster, output);
  else
    end("operator", roster, output);
  return true;
}

void MatchRounds::end(const std::string& cause, const MatchRoster& roster, MatchOutput& output) {
  overAt_ = played_.ticks();
  tellNext(roster, output);
  if (drain_) roster.sendAll(encode(Notice{visibleLabel(drain_->notice)}), output);
  output.add(MatchEvent::Kind::kRoundEnd, 0, 0, cause, *overAt_);
}

// In the pause, tells all players how the round has ended and what comes next.
void MatchRounds::tellNext(const MatchRoster& roster, MatchOutput& output) {
  if (!overAt_) return;
  toldNext_ = rotation_.next(roster.players());
  toldPause_ = pauseTicks(roster);
  roster.sendAll(encode(*roundEnd(roster)), output);
}

std::optional<RoundEnd> MatchRounds::roundEnd(const MatchRoster& roster) const {
  if (!overAt_) return std::nullopt;
  const Level& next = *rotation_.next(roster.players());
  return RoundEnd{played_.number(), *overAt_, next.hash, shownTitle(next), pauseTicks(roster), times_.best(*level())};
}

void MatchRounds::setLevels(std::vector<LevelPointer> levels, const MatchRoster& roster, MatchOutput& output) {
  rotation_.replace(std::move(levels));
  tellNext(roster, output);
}

void MatchRounds::updateLevels(std::vector<LevelPointer> levels, const MatchRoster& roster, MatchOutput& output) {
  rotation_.update(std::move(levels));
  tellNext(roster, output);
}

}  // namespace platon
