#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <tuple>
#include <utility>
#include <vector>

#include "platon/game/game.h"
#include "tests/sim/seeded_random.h"

namespace platon {

/// Searches for places that a player can reach, by random presses in the game itself. It knows nothing of Reach. It
/// goes on from places that it has seen, rare ones more often: a place is a face, an up, a square of 6 units, a speed,
/// open doors and the checkpoint.
class Explorer {
 public:
  Explorer(std::shared_ptr<const Level> level, std::uint64_t seed) : random_(seed) {
    Game game(std::move(level));
    const Input present[] = {validInput(Input::kPresent)};
    game.advance(present);
    keep({game, 0});
  }

  /// Plays so many ticks. Calls visit(game, crossings) after each one; where that returns false, goes on from another
  /// place. `crossings` counts all edges since the start of the game, also before a hazard.
  template <class Visitor>
  void play(std::uint64_t ticks, Visitor&& visit) {
    for (std::uint64_t tick = 0; tick < ticks;) {
      Seen state = next();
      for (auto left = 10 + random_.below(80); left > 0; --left) {
        ++tick;
        if (random_.below(12) == 0) press();
        const std::uint32_t before = state.game.world().entities()[0].crossings;
        const Input inputs[] = {validInput(buttons_)};
        state.game.advance(inputs);
        const std::uint32_t after = state.game.world().entities()[0].crossings;
        if (after > before) state.crossings += after - before;
        if (!visit(std::as_const(state.game), static_cast<int>(state.crossings))) break;
        keep(state);
      }
    }
  }

 private:
  struct Seen {
    Game game;
    std::uint32_t crossings = 0;
    std::uint32_t visits = 0;
  };
  using Key = std::tuple<std::uint32_t, std::int32_t, std::int32_t, std::int32_t, std::int32_t, std::int32_t,
                         std::uint32_t, std::uint32_t, bool>;

  // Buttons are held for a while; runs and jumps are usual.
  void press() {
    const auto draw = random_.below(16);
    const auto aside = draw < 6 ? Input::kLeft : draw < 12 ? Input::kRight : std::uint8_t{0};
    const auto jump = random_.below(2) == 0 ? Input::kJump : std::uint8_t{0};
    const auto other = random_.below(48);
    const auto rare = other < 4     ? Input::kDown
                      : other < 8   ? Input::kWalk
                      : other < 12  ? Input::kCreep
                      : other == 12 ? Input::kRestart
                                    : std::uint8_t{0};
    buttons_ = static_cast<std::uint8_t>(Input::kPresent | aside | jump | rare);
  }

  static Key keyOf(const Seen& state) {
    const EntityState& entity = state.game.world().entities()[0];
    const PlayerState& player = state.game.player(0);
    constexpr std::int32_t square = 6 * kSubunitsPerUnit;
    constexpr std::int32_t speed = 2 * kSubunitsPerUnit;
    return {entity.part,
            entity.angle.centidegrees(),
            entity.position.x / square,
            entity.position.y / square,
            player.velocity.x / speed,
            player.velocity.y / speed,
            state.game.openDoors(),
            player.checkpoint + 10000 * state.crossings,
            player.coyote != 0};
  }

  void keep(const Seen& state) {
    const auto [place, isNew] = seen_.try_emplace(keyOf(state), states_.size());
    if (!isNew || states_.size() >= kMaxStates) return;
    states_.push_back(state);
    states_.back().visits = 0;
  }

  // The one of a few random places that was taken least.
  Seen next() {
    std::size_t best = random_.below(states_.size());
    for (int i = 0; i < 3; ++i) {
      // New places are at the end.
      const std::size_t other =
          i == 0 ? states_.size() - 1 - random_.below(1 + states_.size() / 8) : random_.below(states_.size());
      if (states_[other].visits < states_[best].visits) best = other;
    }
    ++states_[best].visits;
    return states_[best];
  }

  static constexpr std::size_t kMaxStates = 20000;

  sim::SeededRandom random_;
  std::uint8_t buttons_ = Input::kPresent;
  std::map<Key, std::size_t> seen_;
  std::vector<Seen> states_;
};

}  // namespace platon
