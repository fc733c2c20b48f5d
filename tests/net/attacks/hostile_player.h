#pragma once

#include <functional>
#include <optional>
#include <string>

#include "client/bot/button_presser.h"
#include "client/bot/hollow_session.h"
#include "client/net/enet_link.h"
#include "protocol/to_server.h"
#include "tests/net/attacks/flood.h"

namespace platon {

/// What a hostile player does differently.
struct Manners {
  std::function<void(ToServer&, AttackNetwork&, Dice&)> tamper;  ///< changes a message before it is sent
  std::function<void(EnetLink&, const Welcome&, Dice&)> extra;   ///< sends more; every 10 ms
  Time life = std::chrono::hours(1);                             ///< then it vanishes and joins again
  std::optional<Time> deafAfter{};                               ///< from then on it reads and acknowledges nothing
  bool leaves = false;                                           ///< says so before it vanishes
};

/// A client that joins and plays like ours, but with other manners. When its connection ends, it joins again.
class HostilePlayer {
 public:
  HostilePlayer(AttackNetwork& network, const IpAddress& own, const Manners& manners, std::uint64_t seed)
      : network_(network), own_(own), manners_(manners), presser_(seed), name_("mallory " + std::to_string(seed)) {}

  void step(Time now);

 private:
  void begin(Time now);
  void receive(std::span<const std::uint8_t> message, Time now);
  void play(Time now);
  void send();

  AttackNetwork& network_;
  IpAddress own_;
  const Manners& manners_;
  ButtonPresser presser_;
  std::string name_;
  Dice dice_;
  std::optional<EnetLink> connection_;
  std::optional<HollowSession> session_;  // once connected
  std::optional<Welcome> welcome_;
  Time since_{};
  Time extraAt_{};
};

}  // namespace platon
