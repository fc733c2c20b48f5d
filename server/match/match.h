#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "platon/game/game.h"
#include "protocol/to_client.h"
#include "protocol/to_server.h"
#include "server/match/client_id.h"
#include "server/match/level_rotation.h"
#include "server/match/match_event.h"
#include "server/match/match_player.h"
#include "server/match/match_recorder.h"
#include "server/match/tick_history.h"

namespace platon {

struct MatchSettings {
  std::uint32_t maxPlayers = 16;                 ///< 1 … kMaxPlayers
  std::string serverName;                        ///< a label
  bool record = false;                           ///< every round
  std::uint32_t playersPerOrigin = kMaxPlayers;  ///< of one origin, those included that are away
};

/// A message to one client.
struct Outgoing {
  ClientId client = 0;
  bool reliable = false;  ///< else unsequenced
  bool last = false;      ///< the connection ends when it has arrived
  std::vector<std::uint8_t> bytes;
};

/// The authority: it decides every player's input for every tick, moves the game with them and tells all clients what
/// it decided. Knows neither socket nor clock: messages come in decoded, go out encoded, and time is calls of `tick`.
class Match {
 public:
  /// Ticks from the end of a round to the start of the next: 5 s.
  static constexpr std::uint32_t kPauseTicks = 5 * kTicksPerSecond;
  /// Up to so many players, each is told of every tick; of more, only every second tick.
  static constexpr std::size_t kFewPlayers = 4;

  /// Ticks for which the player of a lost connection can be taken back: 60 s.
  static constexpr std::uint64_t kAwayTicks = 60 * kTicksPerSecond;
  /// Bytes of levels and states that one client is sent in one tick, and a piece more: the state of 256 players in
  /// three.
  static constexpr std::size_t kTransferBytesPerTick = 2 * kChunkBytes;

  Match(LevelRotation rotation, MatchSettings settings);

  /// A message from a client; the first has to be Hello. `origin`: the network address it comes from, 0 where these do
  /// not matter. Where one has as many players as it may, whoever of them has been away longest makes room for the
  /// next.
  void receive(ClientId client, const ToServer& message, std::uint32_t origin = 0);
  /// The connection is gone. A player with a token stays, with the buttons it held for a second and then without, until
  /// a client takes it up or kAwayTicks have passed.
  void disconnect(ClientId client);
  /// The client is thrown out, and its player with it.
  void remove(ClientId client);
  /// Decides the inputs of one tick and moves the game. Without any client the match stands still.
  void tick();
  /// Says good-bye to all.
  void stop(const std::string& reason);
  /// These levels follow on the current one.
  void setLevels(std::vector<LevelPointer> levels) { rotation_.replace(std::move(levels)); }

  void setServerName(std::string name) { settings_.serverName = std::move(name); }

  /// What is to be sent, in order, since the last call.
  std::vector<Outgoing> takeOutgoing() { return std::exchange(outgoing_, {}); }
  /// What has happened since the last call.
  std::vector<MatchEvent> takeEvents() { return std::exchange(events_, {}); }
  /// What the recordings of the rounds have grown by since the last call. A recording ends where its game does: when
  /// the next round starts, when the last player leaves, and when the match is stopped.
  std::vector<RecordingPiece> takeRecording() { return recorder_.take(); }

  bool idle() const { return members_.empty() && away_.empty(); }
  std::size_t players() const { return members_.size(); }
  bool isMember(ClientId client) const { return members_.contains(client); }
  std::uint32_t round() const { return round_; }
  const Game& game() const { return game_; }
  /// Null when the client is no member.
  const MatchPlayer* member(ClientId client) const;

 private:
  void greet(ClientId client, const Hello& hello, std::uint32_t origin);
  void handle(ClientId, const Hello&) {}
  void handle(ClientId client, const LevelRequest& request);
  void handle(ClientId client, const Leave& leave);
  void handle(ClientId client, const PlayerInputs& inputs);

  struct Away {
    MatchPlayer member;
    std::uint64_t since = 0;  // now_
  };

  Refused full() const;
  MatchPlayer& join(ClientId client, const Hello& hello, std::uint32_t slot);
  MatchPlayer* takeBack(ClientId client, const Hello& hello);
  std::optional<MatchPlayer> extract(const SessionToken& token);
  void introduce(ClientId client, MatchPlayer& member, const Hello& hello);
  void forgetAway();
  void giveUp(std::vector<Away>::iterator away);
  void makeRoom(std::uint32_t origin, std::uint32_t wanted);
  bool isDismissed(ClientId client) const;
  void removed(const MatchPlayer& member, ClientId client);
  std::optional<std::uint32_t> freeSlot() const;

  void startRound();
  std::vector<Input> decideInputs();
  void watchRound();
  void resync(ClientId client, MatchPlayer& member, MatchEvent::Kind why, std::uint32_t confirmed);
  void sendState(MatchPlayer& member);
  void sendPieces(ClientId client, MatchPlayer& member);
  void sendUpdates();

  void send(ClientId client, std::vector<std::uint8_t> bytes);
  void sendAll(const std::vector<std::uint8_t>& bytes);
  void note(MatchEvent::Kind kind, ClientId client, std::uint32_t slot, std::string text);

  LevelRotation rotation_;
  MatchSettings settings_;
  std::uint32_t round_ = 0;
  std::uint64_t now_ = 0;  // ticks over all rounds
  Game game_;
  TickHistory history_;
  std::optional<std::uint32_t> overAt_;  // tick after which the round was over
  std::map<ClientId, MatchPlayer> members_;
  std::vector<Away> away_;                              // by since
  std::map<std::uint32_t, std::string> rosterChanges_;  // since the last tick, names by slot; empty: gone
  std::vector<Outgoing> outgoing_;
  std::vector<MatchEvent> events_;
  MatchRecorder recorder_;
};

}  // namespace platon
