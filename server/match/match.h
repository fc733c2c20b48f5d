#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "platon/game/game.h"
#include "protocol/to_client.h"
#include "protocol/to_server.h"
#include "protocol/transport/socket_address.h"
#include "server/match/level_rotation.h"
#include "server/match/match_client.h"
#include "server/match/match_output.h"
#include "server/match/match_settings.h"
#include "server/match/match_talk.h"
#include "server/match/played_round.h"
#include "server/match/roster.h"
#include "server/match/round_times.h"
#include "server/match/rounds.h"
#include "server/match/transfers.h"
#include "server/match/updates.h"

namespace platon {

/// What a match asks the program around it.
struct MatchProgram {
  /// How many reliable messages a client can be sent in this tick; empty: any number. Chunks of levels and states wait
  /// for a client that does not keep up.
  std::function<std::size_t(ClientId)> room{};
  /// The round trip to a client, milliseconds; empty: it is unknown, and clients are told none. A client that is alone
  /// is told none.
  std::function<std::uint32_t(ClientId)> roundTrip{};
  /// Keeps the best times of the levels; it must outlive the match. Null: there are none.
  BestTimeKeeper* bestTimes = nullptr;
};

/// The authority over the game: decides the input of every player for every tick, advances the game with them and sends
/// the decided inputs to all clients. Uses neither sockets nor clocks: messages come in decoded and go out encoded, and
/// time passes by calls of `tick`.
class Match {
 public:
  Match(LevelRotation rotation, MatchSettings settings, MatchProgram program = {});

  /// Handles a message from a client that is at this address; its first message must be Hello. The origin of a player
  /// is the household of its address. When an origin has more players than allowed, those of its client that has been
  /// disconnected longest are removed; when all of them are connected, the client is refused, also when it wishes to
  /// resume, and so are companions. Origin 0 has no limit of players.
  void receive(ClientId client, const ToServer& message, const IpAddress& address = IpAddress::ofIpv4({127, 0, 0, 1}));
  /// Moves a client, if it plays, with its players to another address. Returns false, and moves nothing, if the origin
  /// there has no room for them besides the players that are connected.
  bool move(ClientId client, const IpAddress& address) { return roster_.move(client, address, output_); }
  /// Call when the connection of a client was lost. The players of one with a token stay until another client resumes
  /// them or MatchRoster::kResumeTicks have passed; their buttons are held for one second and then released.
  void disconnect(ClientId client) { roster_.disconnect(client, now_, output_); }
  /// Removes the players of a client at once.
  void remove(ClientId client) { roster_.remove(client, output_); }
  /// Decides the inputs of one tick and advances the game. Without any player the game is paused.
  void tick();
  /// Removes all players and tells their clients the reason.
  /// `next`: where they can go on (isNextServer), or empty.
  void stop(const std::string& reason, const std::string& next = {});

  /// Plays these levels after the current one, also when the round has ended already.
  void setLevels(std::vector<LevelPointer> levels) { rounds_.setLevels(std::move(levels), roster_, output_); }
  /// Plays new versions of the levels from the next round on: as many as there are, in the same order.
  void updateLevels(std::vector<LevelPointer> levels) { rounds_.updateLevels(std::move(levels), roster_, output_); }
  /// Whether times may become best times; they may at first. Not: neither may those of the present attempts.
  void countTimes(bool count) { rounds_.countTimes(count); }
  /// Says in which slots the players are whose times MatchSettings::keepsTimesOfOne keeps.
  void keepTimesOf(const SlotsByLocal& slots) { rounds_.keepTimesOf(slots); }
  /// Whether one client at most plays, for whose players the rounds wait: they have no time limit.
  bool waits() const { return rounds_.waits(roster_); }
  /// `name`: a label; invisible characters are left out.
  void setServerName(std::string_view name);

  /// Removes the player of a slot, connected or not, and tells its client the reason, a label of at most
  /// kMaxReasonBytes. The first player of a client goes with its companions, and its connection ends; a companion goes
  /// alone, and its client may have no further one, also after it resumes. Returns false if the slot has no player.
  bool kick(std::uint32_t slot, const std::string& reason);
  /// Shows a player to everybody as "Player N" instead of by its name and passes on nothing that it says, also after it
  /// resumes; or takes that back.
  /// Returns false if the slot has no player.
  bool mute(std::uint32_t slot, bool muted);
  /// Shows a text, a label of at most kMaxReasonBytes, to all connected players for some seconds.
  void say(const std::string& text);
  /// Ends the round; the next one starts after MatchRounds::kPauseTicks, or at once if the match has no players.
  /// Returns false if the round is over already.
  bool endRoundNow() { return rounds_.endNow(roster_, output_); }
  /// Starts the next round at once.
  void startNextRound() { rounds_.startNext(roster_, output_); }
  /// From now on starts no other round by itself and lets no new player join; known players may still resume. `refusal`
  /// answers newcomers. `notice`, a label of at most kMaxReasonBytes, is shown to players who resume, and to all when
  /// the round ends. Another call replaces both.
  void drain(std::string notice, Refused refusal) { rounds_.drain({std::move(notice), std::move(refusal)}); }
  bool draining() const { return rounds_.draining().has_value(); }
  /// Whether nothing is left to play for a match that drains: it has no players, or the pause after its round is over.
  bool drained() const { return draining() && (idle() || rounds_.pauseIsOver()); }

  /// Messages to send, in order, since the last call. They are valid until the next call.
  std::span<const Outgoing> takeOutgoing() { return output_.takeMessages(); }
  /// Events since the last call.
  std::vector<MatchEvent> takeEvents() { return output_.takeEvents(); }
  /// Pieces of recordings since the last call. A recording ends when the next round starts, when the last player
  /// leaves, or when the match is stopped.
  std::vector<RecordingPiece> takeRecording();

  /// Whether the match has no players, neither connected nor disconnected ones.
  bool idle() const { return roster_.idle(); }
  /// Number of players, disconnected ones included.
  std::size_t allPlayers() const { return roster_.size(); }
  /// Number of connected players.
  std::size_t players() const { return roster_.players(); }
  /// Number of connected clients, each with one player or several.
  std::size_t clients() const { return roster_.connected().size(); }
  bool isPlaying(ClientId client) const { return find(client) != nullptr; }
  /// A connected client with its players; null if it does not play.
  const MatchClient* find(ClientId client) const { return roster_.find(client); }
  /// All players, by slot, with the disconnected ones.
  std::vector<PlayerStatus> playerStatus() const { return roster_.status(); }
  const MatchSettings& settings() const { return settings_; }
  std::uint32_t round() const { return rounds_.played().number(); }
  const Game& game() const { return rounds_.played().game(); }
  /// Inputs of all rounds that came too late, and differed from what was decided.
  std::uint64_t missedInputs() const { return roster_.missedInputs(); }

 private:
  void receiveHello(ClientId client, const Hello& hello, const IpAddress& address);
  std::variant<MatchRoster::Seat, Refused> admit(const Hello& hello, const IpAddress& address);
  std::optional<Refused> closed() const;
  void welcome(ClientId id, MatchClient& client, const Hello& hello);
  void greetNewcomers();
  void handle(ClientId, MatchClient&, const Hello&) {}  // only the first one counts
  void handle(ClientId id, MatchClient& client, const LevelRequest& request);
  void handle(ClientId id, MatchClient& client, const Leave& leave);
  void handle(ClientId id, MatchClient& client, const Vote& vote);
  void handle(ClientId id, MatchClient& client, const LocalChat& chat);
  void handle(ClientId id, MatchClient& client, const Companion& companion);
  std::string changeCompanion(ClientId id, MatchClient& client, const Companion& companion);
  std::string addCompanion(ClientId id, const MatchClient& client, const Companion& companion);
  void handle(ClientId id, MatchClient& client, const PlayerInputs& inputs);
  void resync(ClientId id, MatchClient& client, MatchEvent::Kind cause, std::uint32_t confirmed);

  MatchSettings settings_;
  MatchProgram program_;
  std::uint64_t now_ = 0;  // ticks over all rounds
  MatchOutput output_;
  MatchRoster roster_;
  MatchRounds rounds_;
  MatchTransfers transfers_;
  MatchUpdates updates_;
  MatchTalk talk_;
};

}  // namespace platon
