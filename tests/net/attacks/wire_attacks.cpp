#include "tests/net/attacks/wire_attacks.h"

#include "tests/net/attacks/flood.h"
#include "tests/net/attacks/hostile_content.h"

namespace platon {
namespace {

constexpr std::size_t kSlots = 80;

// Sends what `change` makes of a recorded datagram in the name of its sender.
std::unique_ptr<Attacker> floodChanged(AttackNetwork& network, std::function<void(Bytes&, Dice&)> change) {
  return flood(network, [change = std::move(change)](AttackNetwork& to, Dice& dice) {
    const Overheard* const found = anyToServer(to, dice);
    if (found == nullptr) return;
    const SocketAddress victim = found->victim;
    Bytes datagram = found->bytes;
    change(datagram, dice);
    to.send(victim, datagram);
  });
}

/// Overtakes each datagram of a victim with copies from other addresses.
class Racer : public Attacker {
 public:
  explicit Racer(AttackNetwork& network) : network_(network) {
    network_.setEar([this](const Overheard& heard) {
      for (int i = 0; heard.toServer && i < kCopies; ++i) network_.send(anyStranger(network_, dice_), heard.bytes);
    });
  }
  ~Racer() override { network_.setEar({}); }

  void step(Time, int) override {}

 private:
  static constexpr int kCopies = 10;

  AttackNetwork& network_;
  Dice dice_;
};

Bytes unsealedContent(Dice& dice) {
  const auto peer = static_cast<std::uint16_t>(dice.below(kSlots));
  switch (dice.below(5)) {
    case 0:
      return connectContent(static_cast<std::uint32_t>(dice.below(1 << 30)));
    case 1:
      return disconnectContent(peer);
    case 2:
      return pingContent(peer);
    case 3:
      return unreliableContent(peer, static_cast<std::uint16_t>(dice.below(1 << 16)));
    default:
      return fragmentContent(peer);
  }
}

}  // namespace

std::unique_ptr<Attacker> floodForged(AttackNetwork& network) {
  return flood(network, [](AttackNetwork& to, Dice& dice) {
    Bytes datagram = dice.bytes(20 + static_cast<std::size_t>(dice.below(200)));
    datagram[0] |= 0x80;
    datagram[2] = static_cast<std::uint8_t>(dice.below(kSlots));
    datagram[3] = 0;
    to.send(anyVictim(to, dice), datagram);
  });
}

std::unique_ptr<Attacker> floodUnsealed(AttackNetwork& network) {
  return flood(network, [](AttackNetwork& to, Dice& dice) { to.send(anyVictim(to, dice), unsealedContent(dice)); });
}

std::unique_ptr<Attacker> floodReplayed(AttackNetwork& network) {
  return floodChanged(network, [](Bytes&, Dice&) {});
}

std::unique_ptr<Attacker> floodReplayedOpens(AttackNetwork& network) {
  return flood(network, [](AttackNetwork& to, Dice& dice) {
    if (to.opens().empty()) return;
    const Overheard& open = to.opens()[static_cast<std::size_t>(dice.below(to.opens().size()))];
    to.send(dice.below(2) == 0 ? open.victim : anyStranger(to, dice), open.bytes);
  });
}

std::unique_ptr<Attacker> floodMoved(AttackNetwork& network) {
  return flood(network, [](AttackNetwork& to, Dice& dice) {
    const Overheard* const found = anyToServer(to, dice);
    if (found != nullptr) to.send(anyStranger(to, dice), found->bytes);
  });
}

std::unique_ptr<Attacker> race(AttackNetwork& network) { return std::make_unique<Racer>(network); }

std::unique_ptr<Attacker> floodFlipped(AttackNetwork& network) {
  return floodChanged(network, [](Bytes& datagram, Dice& dice) {
    const auto bit = static_cast<std::size_t>(dice.below(8 * datagram.size()));
    datagram[bit / 8] = static_cast<std::uint8_t>(datagram[bit / 8] ^ 1 << bit % 8);
  });
}

std::unique_ptr<Attacker> floodTruncated(AttackNetwork& network) {
  return floodChanged(network, [](Bytes& datagram, Dice& dice) {
    datagram.resize(static_cast<std::size_t>(dice.below(datagram.size())));
  });
}

std::unique_ptr<Attacker> floodReflected(AttackNetwork& network) {
  return flood(network, [](AttackNetwork& to, Dice& dice) {
    const Overheard* const found = anyOverheard(to, dice, [](const Overheard& each) { return !each.toServer; });
    if (found != nullptr) to.send(dice.below(2) == 0 ? found->victim : to.server(), found->bytes);
  });
}

}  // namespace platon
