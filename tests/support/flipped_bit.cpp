#include "tests/support/flipped_bit.h"

#include <stdexcept>

#include "platon/game/state_difference.h"

namespace platon {

namespace {

bool differOnlyIn(const Game& game, const Game& other, const std::string& owner, const std::string& field) {
  const auto here = fieldsOf(game);
  const auto there = fieldsOf(other);
  if (here.size() != there.size()) return false;
  bool differs = false;
  for (std::size_t i = 0; i < here.size(); ++i) {
    if (here[i] == there[i]) continue;
    if (here[i].owner != owner || here[i].name != field) return false;
    differs = true;
  }
  return differs;
}

}  // namespace

std::vector<std::uint8_t> flippedBit(const Game& game, const std::string& owner, const std::string& field) {
  std::vector<std::uint8_t> state = game.save();
  for (std::size_t bit = 0; bit < 8 * state.size(); ++bit) {
    const auto mask = static_cast<std::uint8_t>(1 << bit % 8);
    state[bit / 8] ^= mask;
    Game other = game;
    if (other.restore(state) && differOnlyIn(game, other, owner, field)) return state;
    state[bit / 8] ^= mask;
  }
  throw std::logic_error("no single bit changes only " + field + " of " + owner);
}

}  // namespace platon
