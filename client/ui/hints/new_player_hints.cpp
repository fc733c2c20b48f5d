#include "client/ui/hints/new_player_hints.h"

#include <cstdlib>

#include "platon/exact/integer.h"
#include "platon/game/game.h"
#include "platon/game/player_motion.h"

namespace platon {
namespace {

constexpr std::int64_t kRoll = 60 * kSubunitsPerUnit;             // far enough to see the ball roll
constexpr std::int64_t kRise = 40 * kSubunitsPerUnit;             // of a jump whose key was held
constexpr std::uint32_t kReadTicks = 5 * kTicksPerSecond;         // to read a hint that asks for nothing
constexpr std::uint32_t kStuckTicks = 3 * kTicksPerSecond;        // of pushing
constexpr std::int32_t kStandingSpeed = motion::kCreepSpeed / 4;  // subunits a tick

}  // namespace

void FirstKeys::begin(Step step) {
  step_ = step;
  way_ = 0;
  ticks_ = 0;
}

void FirstKeys::observe(const PlayerState& player, std::uint32_t face) {
  if (done()) return;
  if (!face_) face_ = face;
  crossed_ = crossed_ || face != face_;
  observePush(player);
  observeStep(player);
}

// Rolling on takes twice as fast back what pushing has added: a ball that turns round stands for a moment, too.
void FirstKeys::observePush(const PlayerState& player) {
  const bool pushes = (player.held & (Input::kLeft | Input::kRight)) != 0;
  const bool stands = std::abs(player.velocity.x) < kStandingSpeed;
  if (pushes && stands)
    ++pushed_;
  else if (!stands)
    pushed_ -= pushed_ < 2 ? pushed_ : 2;
  const bool begins = player.startedAt == 0 || (player.held & Input::kRestart) != 0;
  if (begins) pushed_ = 0;
}

void FirstKeys::observeStep(const PlayerState& player) {
  const bool grounded = player.ground != Point();
  switch (step_) {
    case Step::kRun:
      way_ += std::abs(player.velocity.x);
      if (way_ >= kRoll) begin(Step::kJump);
      return;
    case Step::kJump:
      way_ = grounded || player.velocity.y <= 0 ? 0 : way_ + player.velocity.y;
      if (way_ >= kRise) begin(Step::kCross);
      return;
    case Step::kCross:
      if (crossed_) begin(Step::kDown);
      return;
    case Step::kDown:
      if (player.arrived == 0 && ++ticks_ >= kReadTicks) begin(Step::kGoal);
      return;
    case Step::kGoal:
      if (++ticks_ >= kReadTicks || player.arrived != 0) begin(Step::kMenu);
      return;
    case Step::kMenu:
      if (player.arrived == 0 && ++ticks_ >= kReadTicks) begin(Step::kDone);
      return;
    case Step::kDone:
      return;
  }
}

std::string FirstKeys::hint(const KeyHints& keys) const {
  // Who has not jumped yet is not stuck, but at a step.
  if (!done() && step_ != Step::kJump && pushed_ >= kStuckTicks)
    return "Stuck? " + keys.to(Control::kRestart, "back to the start");
  switch (step_) {
    case Step::kRun:
      return keys.run() + ": run";
    case Step::kJump:
      return keys.to(Control::kJump, "jump. Hold it to jump higher");
    case Step::kCross:
      return "Run over the edge to the next face";
    case Step::kDown:
      return "After an edge an arrow shows where down is now: a wall may become a floor";
    case Step::kGoal:
      return "The goal is a glowing ring. From other faces a beam of light shows it";
    case Step::kMenu:
      return keys.menu() + ": pause, settings, back to the title";
    default:
      return {};
  }
}

void NewPlayerHints::observe(const Game& game, std::uint32_t slot, Settings& settings) {
  if (settings.firstKeys == keys_.done()) keys_ = FirstKeys(!settings.firstKeys);  // turned on again, or off
  if (slot >= game.slots() || game.player(slot).present == 0) return;
  const PlayerState player = game.player(slot);
  const EntityState& ball = game.world().entities()[slot];
  keys_.observe(player, ball.part);
  settings.firstKeys = !keys_.done();
  if (keys_.done()) elements_.observe(player, ball, game.level().elements, settings.untold);
}

std::string NewPlayerHints::hint(const KeyHints& keys) const {
  return keys_.done() ? std::string(elements_.hint()) : keys_.hint(keys);
}

}  // namespace platon
