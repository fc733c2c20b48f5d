#pragma once

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "server/match/match.h"
#include "tests/support/test_levels.h"

namespace platon {

/// A match without a network, whose clients have companions: messages take effect at once.
class CompanionTest : public testing::Test {
 protected:
  explicit CompanionTest(const MatchSettings& settings = {.maxPlayers = 8, .serverName = "Test"})
      : match_(LevelRotation({levelOf(farGoalText())}), settings) {}

  /// An address of this household; 0: this machine.
  static IpAddress addressOf(std::uint8_t household) {
    if (household == 0) return IpAddress::ofIpv4({127, 0, 0, 1});
    IpAddress address;
    address.bytes[7] = household;
    return address;
  }

  static Hello helloOf(const std::string& name, std::uint8_t token) {
    Hello hello;
    hello.name = name;
    hello.token = SessionToken{token};
    return hello;
  }
  /// Its token is its number.
  void join(ClientId id, const std::string& name, std::uint8_t household = 0) {
    match_.receive(id, helloOf(name, static_cast<std::uint8_t>(id)), addressOf(household));
    forget();
  }
  void forget() {
    match_.takeOutgoing();
    match_.takeEvents();
  }
  void run(std::uint64_t ticks = 1) {
    for (; ticks > 0; --ticks) match_.tick();
  }
  /// Long enough for the budget of every client to be full again.
  void rest() {
    run(8 * kTicksPerSecond);
    forget();
  }

  /// The messages of this type that a client has been sent since the last call for any client.
  template <class Message>
  std::vector<Message> sentTo(ClientId id) {
    std::vector<Message> found;
    for (const Outgoing& sent : match_.takeOutgoing()) {
      const auto message = decodeToClient(sent.bytes);
      const auto* wanted = message ? std::get_if<Message>(&*message) : nullptr;
      if (wanted && sent.client == id) found.push_back(*wanted);
    }
    return found;
  }
  /// The answer to this message, which is the only one.
  LocalSlots answer(ClientId id, const Companion& companion) {
    match_.takeOutgoing();
    match_.receive(id, companion);
    const std::vector<LocalSlots> answers = sentTo<LocalSlots>(id);
    EXPECT_EQ(answers.size(), 1u) << "client " << id << ", local number " << companion.local;
    if (answers.empty()) return {};
    EXPECT_EQ(answers.front().local, companion.local);
    return {answers.front().slots, answers.front().reason};
  }
  LocalSlots add(ClientId id, std::uint32_t local, const std::string& name) { return answer(id, {local, true, name}); }
  LocalSlots drop(ClientId id, std::uint32_t local) { return answer(id, {local, false}); }

  /// The names of all players by slot.
  std::map<std::uint32_t, std::string> names() const {
    std::map<std::uint32_t, std::string> names;
    for (const PlayerStatus& player : match_.playerStatus()) names[player.slot] = player.name;
    return names;
  }
  /// Kind, client, slot and text of the events since the last call.
  std::vector<std::string> events() {
    static const std::map<MatchEvent::Kind, std::string> kNames{{MatchEvent::Kind::kJoined, "joined"},
                                                                {MatchEvent::Kind::kRefused, "refused"},
                                                                {MatchEvent::Kind::kConnectionLost, "lost"},
                                                                {MatchEvent::Kind::kResumed, "resumed"},
                                                                {MatchEvent::Kind::kRenamed, "renamed"},
                                                                {MatchEvent::Kind::kLeft, "left"},
                                                                {MatchEvent::Kind::kChat, "chat"}};
    std::vector<std::string> texts;
    for (const MatchEvent& event : match_.takeEvents()) {
      const auto name = kNames.find(event.kind);
      if (name == kNames.end()) continue;
      texts.push_back(name->second + " " + std::to_string(event.client) + " " + std::to_string(event.slot) + " " +
                      event.text);
    }
    return texts;
  }
  /// Inputs for the present tick, of the first player and of these companions.
  void press(ClientId id, int buttons, const std::vector<std::uint32_t>& locals) {
    const Input input{static_cast<std::uint8_t>(buttons | Input::kPresent)};
    const std::uint32_t tick = match_.game().tick();
    PlayerInputs message{match_.round(), 0, tick, shortHash(match_.game().hash()), tick, {input}};
    for (const std::uint32_t local : locals) message.companions.push_back({local, tick, {input}});
    match_.receive(id, message);
  }
  bool isPresent(std::uint32_t slot) const {
    return slot < match_.game().slots() && match_.game().player(slot).present != 0;
  }

  Match match_;
};

}  // namespace platon
