#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "platon/game/game.h"
#include "protocol/to_client.h"
#include "protocol/to_server.h"
#include "protocol/transport/socket_address.h"
#include "server/match/best_time_keeper.h"
#include "server/match/chat_budget.h"
#include "server/match/client_id.h"
#include "server/match/level_rotation.h"
#include "server/match/match_event.h"
#include "server/match/match_player.h"
#include "server/match/match_recorder.h"
#include "server/match/player_names.h"
#include "server/match/player_status.h"
#include "server/match/shared_bytes.h"
#include "server/match/tick_history.h"
#include "server/match/transfer_cache.h"
#include "server/match/vote_notices.h"

namespace platon {

struct MatchSettings {
  std::uint32_t maxPlayers = 16;  ///< 1 … kMaxPlayers
  std::string serverName;         ///< a label; invisible characters are left out
  bool record = false;            ///< record every round
  bool chat = true;               ///< players can talk to each other
  bool waitsForOne = false;       ///< rounds of a player who is alone have no time limit, and the next one starts when
                                  ///< asked; a level for several begins anew when as many have joined as it needs
  bool keepsTimesOfOne = false;   ///< only times of attempts in which no more players were connected than the level
                                  ///< needs outlast the server
  std::uint32_t playersPerOrigin = kMaxPlayers;  ///< players of one origin, disconnected ones included
};

/// A message to one client.
struct Outgoing {
  ClientId client = 0;
  bool reliable = false;  ///< otherwise unsequenced
  bool last = false;      ///< close the connection once the message has arrived
  SharedBytes bytes;
};

/// The authority over the game: decides the input of every player for every tick, advances the game with them and sends
/// the decided inputs to all clients. Uses neither sockets nor clocks: messages come in decoded and go out encoded, and
/// time passes by calls of `tick`.
class Match {
 public:
  /// Ticks from the end of a round to the start of the next: 5 s.
  static constexpr std::uint32_t kPauseTicks = 5 * kTicksPerSecond;
  /// Each player is sent the decided ticks every tick while at most kFewPlayers are connected, every second tick while
  /// at most kManyPlayers are, and every third tick otherwise; and in every tick while a message holds too few of
  /// them.
  static constexpr std::size_t kFewPlayers = 4;
  static constexpr std::size_t kManyPlayers = 32;

  /// Fewest ticks between two messages about changed names: 0.25 s.
  static constexpr std::uint64_t kRosterTicks = kTicksPerSecond / 4;

  /// Ticks between two messages about the round trips of the players: 2 s.
  static constexpr std::uint64_t kRoundTripsTicks = 2 * kTicksPerSecond;

  /// Ticks for which a disconnected player can be resumed: 60 s.
  static constexpr std::uint64_t kResumeTicks = 60 * kTicksPerSecond;
  /// Ticks for which a round waits for a disconnected player: 10 s.
  static constexpr std::uint64_t kAwaitTicks = 10 * kTicksPerSecond;
  /// Chunks of levels and states sent to one client in one tick.
  static constexpr std::size_t kClientChunksPerTick = 8;
  /// Chunks of levels and states sent to all clients together in one tick.
  static constexpr std::size_t kMaxChunksPerTick = 256;

  Match(LevelRotation rotation, MatchSettings settings);

  /// Handles a message from a client that is at this address; its first message must be Hello. The origin of a player
  /// is the household of its address. When an origin has more players than allowed, its player that has been
  /// disconnected longest is removed; when all of them are connected, the client is refused, also when it wishes to
  /// resume. Origin 0 has no limit of players.
  void receive(ClientId client, const ToServer& message, const IpAddress& address = {});
  /// Moves the player of a client, if it has one, to another address. Returns false, and moves nothing, if all players
  /// that the origin there may have are connected.
  bool move(ClientId client, const IpAddress& address);
  /// Sets who knows how many reliable messages a client can be sent in this tick; without it, any number. Chunks wait
  /// for a client that does not keep up.
  void setRoom(std::function<std::size_t(ClientId)> room) { room_ = std::move(room); }
  /// Sets who knows the round trip to a client, milliseconds. Without it, clients are told none. A player who is alone
  /// is told none.
  void setRoundTrip(std::function<std::uint32_t(ClientId)> roundTrip) { roundTrip_ = std::move(roundTrip); }
  /// Call when the connection of a client was lost. A player with a token stays until a client resumes it or
  /// kResumeTicks have passed; its buttons are held for one second and then released.
  void disconnect(ClientId client);
  /// Removes the player of a client at once.
  void remove(ClientId client);
  /// Decides the inputs of one tick and advances the game. Without any player the game is paused.
  void tick();
  /// Removes all players and tells their clients the reason.
  /// `next`: where they can go on (isNextServer), or empty.
  void stop(const std::string& reason, const std::string& next = {});
  /// Plays these levels after the current one, also when the round has ended already.
  void setLevels(std::vector<LevelPointer> levels);
  /// Plays new versions of the levels from the next round on: as many as there are, in the same order.
  void updateLevels(std::vector<LevelPointer> levels);
  /// Sets who keeps the best times of the levels; it must outlive the match. Without it, there are none.
  void keepBestTimes(BestTimeKeeper& keeper) { bestTimes_ = &keeper; }
  /// Whether times may become best times; they may at first. Not: neither may those of the present attempts.
  void countTimes(bool count) { countsTimes_ = count; }
  /// Whether the match has one player, whom its rounds wait for: they have no time limit.
  bool waits() const { return settings_.waitsForOne && players_.size() <= 1; }

  /// `name`: a label; invisible characters are left out.
  void setServerName(std::string_view name);

  /// Removes the player of a slot, connected or not, and tells its client the reason, a label of at most
  /// kMaxReasonBytes. Returns false if the slot has no player.
  bool kick(std::uint32_t slot, const std::string& reason);
  /// Shows a player to everybody as "Player N" instead of by its name and passes on nothing that it says, also after it
  /// resumes; or takes that back.
  /// Returns false if the slot has no player.
  bool mute(std::uint32_t slot, bool muted);
  /// Shows a text, a label of at most kMaxReasonBytes, to all connected players for some seconds.
  void say(const std::string& text);
  /// Ends the round; the next one starts after kPauseTicks, or at once if the match has no players. Returns false if
  /// the round is over already.
  bool endRoundNow();
  /// Starts the next round at once.
  void startNextRound();
  /// From now on starts no other round by itself and lets no new player join; known players may still resume. `refusal`
  /// answers newcomers. `notice`, a label of at most kMaxReasonBytes, is shown to players who resume, and to all when
  /// the round ends. Another call replaces both.
  void drain(std::string notice, Refused refusal) { draining_ = Draining{std::move(notice), std::move(refusal)}; }
  bool draining() const { return draining_.has_value(); }
  /// Whether nothing is left to play for a match that drains: it has no players, or the pause after its round is over.
  bool drained() const { return draining_ && (idle() || pauseIsOver()); }

  /// Messages to send, in order, since the last call. They are valid until the next call.
  std::span<const Outgoing> takeOutgoing();
  /// Events since the last call.
  std::vector<MatchEvent> takeEvents() { return std::exchange(events_, {}); }
  /// Pieces of recordings since the last call. A recording ends when the next round starts, when the last player
  /// leaves, or when the match is stopped.
  std::vector<RecordingPiece> takeRecording() { return recorder_.take(); }

  /// Whether the match has no players, neither connected nor disconnected ones.
  bool idle() const { return players_.empty() && disconnected_.empty(); }
  /// Number of players, disconnected ones included.
  std::size_t allPlayers() const { return players_.size() + disconnected_.size(); }
  /// Number of connected players.
  std::size_t players() const { return players_.size(); }
  bool isPlaying(ClientId client) const { return players_.contains(client); }
  const MatchSettings& settings() const { return settings_; }
  std::uint32_t round() const { return round_; }
  const Game& game() const { return game_; }
  /// The player of a client; null if it has none.
  const MatchPlayer* player(ClientId client) const;
  /// All players, by slot, with the disconnected ones.
  std::vector<PlayerStatus> playerStatus() const;
  /// Ticks of all rounds that were decided without the input of a connected player.
  std::uint64_t missedInputs() const { return missedInputs_; }

 private:
  struct Disconnected {
    MatchPlayer player;
    std::uint64_t since = 0;  // value of now_
  };

  struct Draining {
    std::string notice;
    Refused refusal;
  };

  void handleHello(ClientId client, const Hello& hello, const IpAddress& address);
  void handle(ClientId, const Hello&) {}
  void handle(ClientId client, const LevelRequest& request);
  void handle(ClientId client, const Leave& leave);
  void handle(ClientId client, const Vote& vote);
  void handle(ClientId client, const Chat& chat);
  bool mayChat(const IpAddress& address);
  void handle(ClientId client, const PlayerInputs& inputs);

  /// The player of the client, or why it gets none.
  std::variant<MatchPlayer*, Refused> admit(ClientId client, const Hello& hello, std::uint64_t origin);
  bool isFull(std::uint64_t origin, const MatchPlayer* arriving) const;
  std::int64_t connectedOf(std::uint64_t origin, const MatchPlayer* except = nullptr) const;
  Refused refuseOrigin() const;
  Refused refuseFull() const;
  MatchPlayer& join(ClientId client, const Hello& hello, std::uint32_t slot);
  MatchPlayer& resume(ClientId client, const Hello& hello, const MatchPlayer& known);
  const MatchPlayer* playerWith(const SessionToken& token) const;
  MatchPlayer extractPlayer(const MatchPlayer& known);
  void sendWelcome(ClientId client, MatchPlayer& player, const Hello& hello);
  void expireDisconnected();
  void removeDisconnected(std::vector<Disconnected>::iterator disconnected);
  void evictDisconnected(std::uint64_t origin, std::uint32_t wanted);
  bool isClosing(ClientId client) const;
  void playerLeft(const MatchPlayer& player, ClientId client);
  std::optional<std::uint32_t> freeSlot() const;

  void startRound();
  void restartRound();
  bool completesLevel() const;
  void sendRosters();
  std::vector<Input> decideInputs();
  std::uint32_t pauseTicks() const { return waits() ? 0 : kPauseTicks; }
  bool roundOver() const;
  bool pauseIsOver() const { return overAt_ && history_.end() - *overAt_ >= kPauseTicks; }
  bool someoneHasFinished() const;
  bool awaits(const MatchPlayer& player) const;
  void finishRound();
  void noteFinishes();
  void noteTick();
  bool arrives(std::uint32_t slot) const;
  VoteCount countVotes();
  void endRound(const std::string& cause);
  void tellNext();
  RoundEnd roundEnd() const;
  void resync(ClientId client, MatchPlayer& player, MatchEvent::Kind cause, std::uint32_t confirmed);
  void sendState(MatchPlayer& player);
  void sendTransfers();
  std::size_t sendChunks(ClientId client, MatchPlayer& player, std::size_t maxChunks);
  std::uint32_t sendInterval() const;
  void sendTicks();
  void sendRoundTrips();

  void send(ClientId client, SharedBytes bytes);
  void sendAll(const SharedBytes& bytes);
  void addEvent(MatchEvent::Kind kind, ClientId client, std::uint32_t slot, std::string text);

  LevelRotation rotation_;
  LevelPointer toldNext_;        // in the pause: the next level, as the players have been told
  std::uint32_t toldPause_ = 0;  // and its length
  MatchSettings settings_;
  std::uint32_t round_ = 0;
  std::uint64_t now_ = 0;  // ticks over all rounds
  Game game_;
  TickHistory history_;
  std::optional<Draining> draining_;         // nothing: players may join, and rounds follow each other
  std::optional<std::uint32_t> overAt_;      // ticks of the round when its end was detected
  std::optional<std::uint64_t> finishedAt_;  // value of now_ when a player first finished this round
  std::map<ClientId, MatchPlayer> players_;  // connected ones
  std::vector<Disconnected> disconnected_;   // ordered by since
  PlayerNames names_;                        // of the connected and the disconnected players
  std::uint64_t nextRosterAt_ = 0;           // value of now_
  VoteNotices voteNotices_;
  NetworkChat householdChat_;
  NetworkChat siteChat_{NetworkChat::kMaxSpeakers};
  BestTimeKeeper* bestTimes_ = nullptr;  // null: none
  bool countsTimes_ = true;
  std::uint32_t uncountedAt_ = 0;    // last tick of the round in which times did not count; 0: none
  std::uint32_t sharedAt_ = 0;       // last tick of the round with more players than the level needs; 0: none
  std::vector<bool> arrived_;        // by slot: at the goal in the tick before the last one
  bool bestIsNew_ = false;           // the best time of the level was reached in this round
  std::vector<ClientId> newcomers_;  // clients that joined or resumed since the last tick
  TransferCache transfers_;
  std::function<std::size_t(ClientId)> room_;
  std::function<std::uint32_t(ClientId)> roundTrip_;
  ClientId nextTransfer_ = 0;  // client whose transfers go on first in the next tick
  std::uint64_t missedInputs_ = 0;
  std::vector<Outgoing> outgoing_;
  std::vector<Outgoing> taken_;  // by the last call of takeOutgoing
  ConfirmedTicks ticks_;         // the last ones sent
  std::vector<MatchEvent> events_;
  MatchRecorder recorder_;
};

}  // namespace platon
