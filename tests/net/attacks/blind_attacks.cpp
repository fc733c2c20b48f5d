#include "tests/net/attacks/blind_attacks.h"

#include "protocol/limits.h"
#include "protocol/transport/handshake.h"
#include "tests/net/attacks/flood.h"

namespace platon {
namespace {

constexpr auto kVersion = static_cast<std::uint16_t>(kProtocolVersion);
constexpr std::size_t kLongestUnsplit = 1472;  // in an Ethernet frame

CryptoKey anyKey(Dice& dice) {
  CryptoKey key;
  dice.fill(key);
  return key;
}

}  // namespace

std::unique_ptr<Attacker> floodEmpty(AttackNetwork& network) {
  return flood(network, [](AttackNetwork& to, Dice& dice) {
    to.send(dice.below(2) == 0 ? anyStranger(to, dice) : anyVictim(to, dice), {});
  });
}

std::unique_ptr<Attacker> floodOversized(AttackNetwork& network) {
  return flood(network, [](AttackNetwork& to, Dice& dice) {
    const auto more = static_cast<std::size_t>(dice.below(kLongestUnsplit - kMaxDatagramBytes));
    Bytes datagram(kMaxDatagramBytes + 1 + more);
    dice.fill(std::span(datagram).first(4));
    to.send(anyStranger(to, dice), datagram);
  });
}

std::unique_ptr<Attacker> floodRandom(AttackNetwork& network) {
  return flood(network, [](AttackNetwork& to, Dice& dice) {
    to.send(anyStranger(to, dice), dice.bytes(1 + static_cast<std::size_t>(dice.below(300))));
  });
}

std::unique_ptr<Attacker> floodKnocks(AttackNetwork& network) {
  return flood(network, [](AttackNetwork& to, Dice& dice) {
    to.send(anyStranger(to, dice), encode(Knock{kVersion, anyKey(dice)}));
  });
}

std::unique_ptr<Attacker> floodVictimKnocks(AttackNetwork& network) {
  return flood(network, [](AttackNetwork& to, Dice& dice) {
    to.send(anyVictim(to, dice), encode(Knock{kVersion, anyKey(dice)}));
  });
}

std::unique_ptr<Attacker> floodVersions(AttackNetwork& network) {
  return flood(network, [](AttackNetwork& to, Dice& dice) {
    const auto version = static_cast<std::uint16_t>(kVersion + 1 + dice.below(1000));
    to.send(anyStranger(to, dice), encode(Knock{version, anyKey(dice)}));
  });
}

std::unique_ptr<Attacker> floodBadCookies(AttackNetwork& network) {
  return flood(network, [](AttackNetwork& to, Dice& dice) {
    Open open;
    dice.fill(open.cookie);
    dice.fill(open.exchange);
    to.send(dice.below(2) == 0 ? anyStranger(to, dice) : anyVictim(to, dice), encode(open));
  });
}

std::unique_ptr<Attacker> floodQueries(AttackNetwork& network) {
  return flood(network, [](AttackNetwork& to, Dice& dice) {
    to.send(anyStranger(to, dice), encode(Query{static_cast<std::uint64_t>(dice.below(1 << 30))}));
  });
}

}  // namespace platon
