#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "platon/game/game.h"
#include "protocol/to_client.h"
#include "protocol/to_server.h"
#include "server/match/level_rotation.h"
#include "server/match/match_client.h"
#include "server/match/match_output.h"
#include "server/match/match_settings.h"
#include "server/match/played_round.h"
#include "server/match/round_times.h"

namespace platon {

class MatchRoster;

/// Whether the vote has passed: more than half of the voters wish the next level.
constexpr bool votePasses(const VoteCount& count) { return 2 * count.votes > count.voters; }

/// Which counts of the vote clients are told: each that differs from the last one, but at most one in kMinTicks, and
/// none while nobody votes.
class VoteNotices {
 public:
  static constexpr std::uint64_t kMinTicks = kTicksPerSecond / 4;

  /// Forgets what clients were told in the last round.
  void startRound() { told_ = VoteCount(); }
  /// The count to tell all clients of at tick `now` of the match, if there is one. `now` never decreases.
  std::optional<VoteCount> take(VoteCount count, std::uint64_t now) {
    if (count.votes == 0) count.voters = 0;
    const bool same = count.votes == told_.votes && count.voters == told_.voters;
    if (same || now < nextAt_) return std::nullopt;
    nextAt_ = now + kMinTicks;
    return told_ = count;
  }
  /// What a newcomer is told.
  std::optional<VoteCount> told() const { return told_.votes > 0 ? std::optional(told_) : std::nullopt; }

 private:
  VoteCount told_;
  std::uint64_t nextAt_ = 0;
};

/// What players of a match are told that drains: it starts no other round and lets no new player join.
struct MatchDrain {
  std::string notice;  ///< a label of at most kMaxReasonBytes
  Refused refusal;     ///< answers newcomers
};

/// The rounds of a match, one after the other: which level each is played on, when it ends, and the pause in which
/// players see how it has ended and what comes next. A round ends when all players that it waits for have finished,
/// when the time is up, or when a vote has passed.
class MatchRounds {
 public:
  /// Ticks from the end of a round to the start of the next: 5 s.
  static constexpr std::uint32_t kPauseTicks = 5 * kTicksPerSecond;
  /// Ticks for which a round waits for a disconnected player: 10 s.
  static constexpr std::uint64_t kAwaitTicks = 10 * kTicksPerSecond;

  /// Starts the first round. `keeper`: as for RoundTimes.
  MatchRounds(LevelRotation rotation, const MatchSettings& settings, BestTimeKeeper* keeper, MatchOutput& output);

  /// The round that is played.
  PlayedRound& played() { return played_; }
  const PlayedRound& played() const { return played_; }
  /// Its level.
  const LevelPointer& level() const { return rotation_.current(); }
  /// The level of the rotation with this hash; null if there is none.
  LevelPointer findLevel(std::uint64_t hash) const { return rotation_.find(hash); }
  /// Whether times may become best times.
  void countTimes(bool count) { times_.count(count); }
  /// As RoundTimes::keepOf.
  void keepTimesOf(const SlotsByLocal& slots) { times_.keepOf(slots); }

  /// Call before a new player joins. Starts a round if nobody is left who plays the present one, or if those who were
  /// too few for a level for several have waited for this one.
  void awaitPlayer(MatchRoster& roster, MatchOutput& output);
  /// Call after each tick: ends the round when it is over, and starts the next one after the pause.
  void proceed(MatchRoster& roster, std::uint64_t now, MatchOutput& output);
  /// Ends the round as the operator wishes. Returns false if it is over already.
  bool endNow(MatchRoster& roster, MatchOutput& output);
  /// Starts the next round at once.
  void startNext(MatchRoster& roster, MatchOutput& output);
  /// The vote of a client at tick `now` of the match.
  void vote(MatchClient& client, const Vote& vote, std::uint64_t now);

  /// Plays these levels after the current one (LevelRotation::replace), or new versions of the levels from the next
  /// round on (LevelRotation::update). In the pause, tells all players what comes next now.
  void setLevels(std::vector<LevelPointer> levels, const MatchRoster& roster, MatchOutput& output);
  void updateLevels(std::vector<LevelPointer> levels, const MatchRoster& roster, MatchOutput& output);

  /// Drains the match from now on.
  void drain(MatchDrain drain) { drain_ = std::move(drain); }
  /// Nothing while players may join and rounds follow each other.
  const std::optional<MatchDrain>& draining() const { return drain_; }
  /// Whether the pause after the round has passed.
  bool pauseIsOver() const { return overAt_ && played_.ticks() - *overAt_ >= kPauseTicks; }
  /// Whether rounds have no time limit, because they wait for those who play at one machine, or for nobody.
  bool waits(const MatchRoster& roster) const;

  /// In the pause: how the round has ended, and what comes next.
  std::optional<RoundEnd> roundEnd(const MatchRoster& roster) const;
  /// The count of the vote that players know; nothing if nobody has voted.
  std::optional<VoteCount> toldVotes() const { return voteNotices_.told(); }

 private:
  void noteStart(MatchOutput& output) const;
  void start(MatchRoster& roster, MatchOutput& output);
  bool completesLevel(const MatchRoster& roster) const;
  void pause(MatchRoster& roster, MatchOutput& output);
  std::uint32_t pauseTicks(const MatchRoster& roster) const { return waits(roster) ? 0 : kPauseTicks; }
  void end(const std::string& cause, const MatchRoster& roster, MatchOutput& output);
  void tellNext(const MatchRoster& roster, MatchOutput& output);
  VoteCount countVotes(MatchRoster& roster, std::uint64_t now) const;
  bool someoneHasFinished() const;
  bool isOver(const MatchRoster& roster, std::uint64_t now) const;
  bool awaitsAnyOf(const MatchClient& client, std::uint64_t now) const;
  bool awaits(const MatchPlayer& player, std::uint64_t now) const;

  LevelRotation rotation_;
  PlayedRound played_;
  RoundTimes times_;
  bool waitsForOne_;                         // MatchSettings::waitsForOne
  LevelPointer toldNext_;                    // in the pause: the next level, as the players have been told
  std::uint32_t toldPause_ = 0;              // and its length
  std::optional<std::uint32_t> overAt_;      // ticks of the round when its end was detected
  std::optional<std::uint64_t> finishedAt_;  // tick of the match in which a player first finished this round
  VoteNotices voteNotices_;
  std::optional<MatchDrain> drain_;
};

}  // namespace platon
