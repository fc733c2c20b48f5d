#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "platon/game/game.h"
#include "protocol/to_client.h"
#include "protocol/to_server.h"
#include "protocol/transfer.h"
#include "tests/net/support/virtual_client.h"

namespace platon {

/// A minimal client that implements docs/protocol.md without clock or network. It shares no code with the real client
/// except the messages.
class FakeClient : public VirtualClient {
 public:
  /// The pressed buttons of a tick.
  using Buttons = std::function<int(std::uint32_t)>;

  /// `lead`: number of ticks for which it sends inputs ahead of the confirmed tick.
  FakeClient(std::string name, std::uint32_t lead, Buttons buttons);
  /// Resumes the players of `disconnected` and knows its levels. Its companions press what they pressed.
  FakeClient(const FakeClient& disconnected, Buttons buttons);

  void receive(std::vector<std::uint8_t> bytes, Time now) override;
  /// Sends the inputs of this tick. Without a game it sends nothing.
  void update(Time now) override;
  std::vector<OutgoingMessage> takeOutgoing() override { return std::exchange(outgoing_, {}); }

  const std::optional<Welcome>& welcome() const { return welcome_; }
  const std::optional<Refused>& refused() const { return refused_; }
  const std::optional<Bye>& bye() const { return bye_; }
  const std::vector<std::string>& notices() const { return notices_; }
  const std::map<std::uint32_t, std::string>& roster() const { return roster_; }
  const std::optional<RoundEnd>& roundEnd() const { return roundEnd_; }
  /// All that players have said, in order.
  const std::vector<PlayerChat>& chats() const { return chats_; }
  /// All counts of votes, in order.
  const std::vector<VoteCount>& voteCounts() const { return voteCounts_; }

  const SessionToken& token() const { return token_; }
  std::uint32_t round() const { return round_; }
  /// Number of confirmed ticks.
  std::uint32_t confirmed() const { return confirmed_; }
  const std::optional<Game>& game() const { return game_; }
  /// Hash of the confirmed game by number of ticks played in this round.
  const std::map<std::uint32_t, std::uint64_t>& hashes() const { return hashes_; }
  /// Inputs that the server decided for the player with this local number, by tick of this round.
  const std::map<std::uint32_t, Input>& decided(std::uint32_t local = 0) const { return players_[local].decided; }
  /// The slot of this player, as the server has told; nothing: it has none.
  std::optional<std::uint32_t> slot(std::uint32_t local = 0) const { return players_[local].slot; }
  /// All LocalSlots, in order.
  const std::vector<LocalSlots>& localSlots() const { return localSlots_; }
  std::uint32_t desyncs() const { return desyncs_; }
  std::uint32_t states() const { return states_; }
  std::uint32_t levels() const { return levels_; }
  /// The slack of the last link report that had one.
  const std::optional<SlackReport>& slack() const { return slack_; }

  void setLead(std::uint32_t lead) { lead_ = lead; }
  /// Sends a vote for the present round, or for another one.
  void vote(bool next) { vote(round_, next); }
  void vote(std::uint32_t round, bool next);
  void say(const Chat& chat, std::uint32_t local = 0);
  /// Asks for a companion with this local number, or for another name of it. While it has a slot, it presses this.
  void addCompanion(std::uint32_t local, const std::string& name, Buttons buttons);
  void removeCompanion(std::uint32_t local);
  /// Changes the confirmed game, so that it is in desync.
  void corruptGame();

 private:
  struct Player {
    Buttons buttons;
    std::optional<std::uint32_t> slot;
    std::map<std::uint32_t, Input> decided;  // by tick of this round
  };

  template <class Message>
  void send(const Message& message, bool reliable);
  void handle(const Welcome& message);
  void handle(const Refused& message) { refused_ = message; }
  void handle(const LevelChunk& message);
  void handle(const StateChunk& message);
  void handle(const Roster& message) {
    for (const RosterEntry& entry : message.entries) roster_[entry.slot] = entry.name;
  }
  void handle(const RoundStart& message);
  void handle(const RoundEnd& message) { roundEnd_ = message; }
  void handle(const VoteCount& message) { voteCounts_.push_back(message); }
  void handle(const PlayerChat& message) { chats_.push_back(message); }
  void handle(const RoundTrips&) {}
  void handle(const LocalSlots& message);
  void handle(const Bye& message) { bye_ = message; }
  void handle(const Notice& message) { notices_.push_back(message.text); }
  void handle(const ConfirmedTicks& message);

  bool startRound(std::uint32_t round, std::uint64_t levelHash);
  void play();
  std::vector<Input> inputsOf(const Player& player, std::uint32_t first) const;

  std::uint32_t lead_;
  std::array<Player, kMaxLocalPlayers> players_;  // by local number
  SessionToken token_{};
  std::vector<OutgoingMessage> outgoing_;
  std::map<std::uint64_t, std::shared_ptr<const Level>> texts_;
  std::optional<Welcome> welcome_;
  std::optional<Refused> refused_;
  std::optional<Bye> bye_;
  std::vector<std::string> notices_;
  std::optional<RoundEnd> roundEnd_;
  std::vector<VoteCount> voteCounts_;
  std::vector<PlayerChat> chats_;
  std::vector<LocalSlots> localSlots_;
  std::optional<SlackReport> slack_;
  std::map<std::uint32_t, std::string> roster_;
  std::uint32_t round_ = 0;
  std::uint64_t levelHash_ = 0;
  std::uint8_t sync_ = 0;
  std::uint8_t sequence_ = 0;
  std::uint32_t confirmed_ = 0;
  std::uint32_t firstInput_ = 0;
  std::optional<Game> game_;
  std::vector<Input> held_;
  Assembly levelAssembly_;
  Assembly stateAssembly_;
  std::map<std::uint32_t, std::uint64_t> hashes_;
  std::uint32_t desyncs_ = 0;
  std::uint32_t states_ = 0;
  std::uint32_t levels_ = 0;
};

}  // namespace platon
