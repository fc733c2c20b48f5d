#pragma once

#include <functional>
#include <memory>
#include <random>
#include <utility>

#include "tests/net/attacks/attack.h"

namespace platon {

/// Random numbers of an attack; the same in every run.
class Dice {
 public:
  int below(std::size_t limit) { return static_cast<int>(random_() % limit); }
  void fill(std::span<std::uint8_t> bytes) {
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random_());
  }
  Bytes bytes(std::size_t size) {
    Bytes made(size);
    fill(made);
    return made;
  }

 private:
  std::mt19937_64 random_{1};
};

/// Sends datagrams that need no answer, one with each call of `next`.
class Flood : public Attacker {
 public:
  using Next = std::function<void(AttackNetwork&, Dice&)>;

  Flood(AttackNetwork& network, Next next) : network_(network), next_(std::move(next)) {}

  void step(Time, int datagrams) override {
    for (int i = 0; i < datagrams; ++i) next_(network_, dice_);
  }

 private:
  AttackNetwork& network_;
  Next next_;
  Dice dice_;
};

inline std::unique_ptr<Attacker> flood(AttackNetwork& network, Flood::Next next) {
  return std::make_unique<Flood>(network, std::move(next));
}

inline SocketAddress anyStranger(const AttackNetwork& network, Dice& dice) {
  return strangerAddress(network.version(), dice.below(kStrangers));
}

/// One of the last datagrams of the victims that satisfies `fits`; null if there is none.
template <class Fits>
const Overheard* anyOverheard(const AttackNetwork& network, Dice& dice, Fits fits) {
  const std::deque<Overheard>& all = network.overheard();
  for (int attempt = 0; attempt < 64 && !all.empty(); ++attempt) {
    const Overheard& found = all[static_cast<std::size_t>(dice.below(all.size()))];
    if (fits(found)) return &found;
  }
  return nullptr;
}

inline const Overheard* anyToServer(const AttackNetwork& network, Dice& dice) {
  return anyOverheard(network, dice, [](const Overheard& each) { return each.toServer; });
}

/// The address of a victim, or of a stranger before one was overheard.
inline SocketAddress anyVictim(const AttackNetwork& network, Dice& dice) {
  const Overheard* found = anyToServer(network, dice);
  return found == nullptr ? anyStranger(network, dice) : found->victim;
}

}  // namespace platon
