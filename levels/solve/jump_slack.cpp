#include "levels/solve/jump_slack.h"

#include <algorithm>
#include <cstdlib>
#include <vector>

namespace platon {
namespace {

constexpr int kLandingTicks = 30;                           // a shifted jump may land this much later
constexpr std::int32_t kSameHeight = 3 * kSubunitsPerUnit;  // as where the jump of the solution landed

// Where a player has landed: on a face, at a height along its up.
struct Landing {
  std::uint32_t face = 0;
  Angle up;
  std::int32_t height = 0;

  static std::optional<Landing> of(const Game& game, std::uint32_t slot) {
    if (game.player(slot).ground == Point() && game.player(slot).arrived == 0) return std::nullopt;
    const EntityState& entity = game.world().entities()[slot];
    return Landing{entity.part, entity.angle, rotate(entity.position, -entity.angle).y};
  }
  bool isAt(const Landing& other) const {
    return face == other.face && up == other.up && std::abs(height - other.height) <= kSameHeight;
  }
};

class JumpSlack {
 public:
  JumpSlack(const std::shared_ptr<const Level>& level, const Solution& solution) : solution_(solution) {
    Game game(level);
    games_.push_back(game);
    for (const std::vector<Input>& inputs : solution) {
      game.advance(inputs);
      games_.push_back(game);
    }
  }

  // Nothing when no jump starts in this tick, or when it never lands.
  std::optional<int> of(std::size_t tick, std::uint32_t slot) const {
    if (!startsJump(tick, slot)) return std::nullopt;
    const auto landed = landingAfter(tick, slot);
    if (!landed) return std::nullopt;
    const Landing aim = *Landing::of(games_[*landed], slot);
    int slack = 1;
    for (const int way : {-1, 1}) {
      for (int shift = 1; shift <= kMaxSlack && lands(tick, *landed - tick, slot, way * shift, aim); ++shift) ++slack;
    }
    return slack;
  }

 private:
  bool startsJump(std::size_t tick, std::uint32_t slot) const {
    if (slot >= games_[tick].slots()) return false;
    const PlayerState& before = games_[tick].player(slot);
    const PlayerState& after = games_[tick + 1].player(slot);
    return after.jumping != 0 && (before.jumping == 0 || after.velocity.y > before.velocity.y);
  }
  // The number of ticks after which the player stands again.
  std::optional<std::size_t> landingAfter(std::size_t tick, std::uint32_t slot) const {
    for (std::size_t at = tick + 1; at < games_.size(); ++at) {
      if (Landing::of(games_[at], slot)) return at;
    }
    return std::nullopt;
  }
  // Whether the jump lands there when it starts `shift` ticks later, or earlier if negative.
  bool lands(std::size_t tick, std::size_t flight, std::uint32_t slot, int shift, const Landing& aim) const {
    const auto first = static_cast<std::ptrdiff_t>(tick) + std::min(shift, 0);
    if (first < 1) return false;
    Game game = games_[static_cast<std::size_t>(first)];
    const Input before = solution_[static_cast<std::size_t>(first) - 1][slot];
    const auto play = [&](Input input, std::size_t at) {
      std::vector<Input> inputs = solution_[std::min(at, solution_.size() - 1)];
      inputs[slot] = input;
      game.advance(inputs);
    };
    std::size_t now = static_cast<std::size_t>(first);
    const Input waiting{static_cast<std::uint8_t>(before.buttons & ~Input::kJump)};
    for (int late = 0; late < shift; ++late) play(waiting, now++);
    for (std::size_t i = 0; i < flight + kLandingTicks; ++i) {
      const std::size_t at = std::min(tick + std::min(i, flight - 1), solution_.size() - 1);
      play(solution_[at][slot], now++);
      if (game.player(slot).arrived != 0) return true;
      if (i > 3 && game.player(slot).ground != Point()) return Landing::of(game, slot)->isAt(aim);
    }
    return false;
  }

  const Solution& solution_;
  std::vector<Game> games_;  // after 0, 1 … ticks
};

}  // namespace

std::optional<int> tightestJump(const std::shared_ptr<const Level>& level, const Solution& solution) {
  const JumpSlack slack(level, solution);
  std::optional<int> tightest;
  for (std::size_t tick = 0; tick < solution.size(); ++tick) {
    for (std::uint32_t slot = 0; slot < solution[tick].size(); ++slot) {
      const auto jump = slack.of(tick, slot);
      if (jump) tightest = std::min(tightest.value_or(*jump), *jump);
    }
  }
  return tightest;
}

}  // namespace platon
