#include "client/ui/hints/new_player_hints.h"

#include <algorithm>
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
constexpr std::uint32_t kKeysTurnTicks = 8 * kTicksPerSecond;     // after which an element has its turn, or the keys
constexpr std::uint32_t kLookHintTicks = 15 * kTicksPerSecond;    // who has not looked round until then, need not
constexpr std::uint32_t kLookedTicks = kTicksPerSecond / 3;       // enough to see the solid turn
constexpr std::int32_t kStandingSpeed = motion::kCreepSpeed / 4;  // subunits a tick
constexpr std::int32_t kLeastTurn = 3000;                         // of down, centidegrees

// Who has turned the hints off, or knows all keys and elements, needs none.
bool needsHints(const Settings& settings) { return settings.firstKeys || settings.untold != UntoldElements{0}; }

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
  ++ticks_;
  if (player.arrived != 0) return begin(Step::kDone);
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
      if (crossed_) begin(Step::kGoal);
      return;
    case Step::kGoal:
      if (ticks_ >= kReadTicks) begin(Step::kDone);
      return;
    case Step::kDone:
      return;
  }
}

std::string FirstKeys::hint(const KeyHints& keys) const {
  switch (step_) {
    case Step::kRun:
      return keys.run() + ": run";
    case Step::kJump:
      return keys.to(Control::kJump, "jump. Hold it to jump higher");
    case Step::kCross:
      return "Run over the edge to the next face";
    case Step::kGoal:
      return "The goal is the glowing ring. A beam of light shows where it is";
    default:
      return {};
  }
}

// Rolling on takes twice as fast back what pushing has added: a ball that turns round stands for a moment, too. Half a
// second of rolling shows that it is not stuck, however long it was pushed.
void PushedBall::observe(const PlayerState& player) {
  const bool pushes = (player.held & (Input::kLeft | Input::kRight)) != 0;
  const bool stands = std::abs(player.velocity.x) < kStandingSpeed;
  if (pushes && stands)
    pushed_ = std::min(pushed_ + 1, kStuckTicks + kTicksPerSecond);
  else if (!stands)
    pushed_ -= pushed_ < 2 ? pushed_ : 2;
  const bool begins = player.startedAt == 0 || (player.held & Input::kRestart) != 0;
  if (begins) pushed_ = 0;
}

bool PushedBall::stuck() const { return pushed_ >= kStuckTicks; }

void TurnedDown::observe(const PlayerState& player, const EntityState& ball) {
  if (player.startedAt == 0) *this = TurnedDown();
  const auto before = ups_.find(ball.part);
  if (face_ != ball.part && before != ups_.end()) {
    const std::int32_t turn = (ball.angle - before->second).centidegrees();
    turned_ = turned_ || std::min(turn, Angle::kTurn - turn) >= kLeastTurn;
  }
  face_ = ball.part;
  ups_[ball.part] = ball.angle;
}

void NewPlayerHints::observe(const Game& game, std::uint32_t slot, bool looks, Settings& settings) {
  if (settings.firstKeys == keys_.done()) keys_ = FirstKeys(!settings.firstKeys);  // turned on again, or off
  if (slot >= game.slots() || game.player(slot).present == 0) return;
  note(game, slot, looks, settings);
  shown_ = chosen(game, slot, settings);
}

void NewPlayerHints::note(const Game& game, std::uint32_t slot, bool looks, Settings& settings) {
  const PlayerState player = game.player(slot);
  const EntityState& ball = game.world().entities()[slot];
  keys_.observe(player, ball.part);
  settings.firstKeys = !keys_.done();
  push_.observe(player);
  down_.observe(player, ball);
  elements_.observe(player, ball, game.level().elements, shown_ == Shown::kElement, settings.untold);
  looked_ += looks ? 1 : 0;
  const bool plays = player.startedAt != 0;
  if (shown_ == Shown::kDown && ++downTicks_ >= kReadTicks) settings.firstDown = false;
  if (shown_ == Shown::kLook && plays && ++lookTicks_ >= kLookHintTicks) settings.firstLook = false;
  if (looked_ >= kLookedTicks) settings.firstLook = false;
  if (!settings.firstDown) downTicks_ = 0;
  if (!settings.firstLook) lookTicks_ = looked_ = 0;
}

// Who has not jumped yet is not stuck, but at a step.
NewPlayerHints::Shown NewPlayerHints::chosen(const Game& game, std::uint32_t slot, const Settings& settings) const {
  if (game.player(slot).arrived != 0 || !needsHints(settings)) return Shown::kNone;
  if (push_.stuck() && keys_.hasJumped()) return Shown::kStuck;
  if (elements_.isDue()) return Shown::kElement;
  const bool othersTurn = keys_.ticks() / kKeysTurnTicks % 2 == 1 && !elements_.hint().empty();
  if (!keys_.done()) return othersTurn ? Shown::kElement : Shown::kKeys;
  if (settings.firstDown && down_.turned()) return Shown::kDown;
  if (settings.firstLook && game.level().goalFace != game.world().entities()[slot].part) return Shown::kLook;
  return Shown::kElement;
}

std::string NewPlayerHints::hint(const KeyHints& keys) const {
  switch (shown_) {
    case Shown::kStuck:
      return "Stuck? " + keys.to(Control::kRestart, "back to the start");
    case Shown::kKeys:
      return keys_.hint(keys);
    case Shown::kDown:
      return "Down has turned: a wall may be a floor now";
    case Shown::kLook:
      return keys.look() + ": look round for a way to the goal";
    case Shown::kElement:
      return std::string(elements_.hint());
    default:
      return {};
  }
}

}  // namespace platon
