#include "client/audio/player_cues.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "platon/game/input.h"
#include "platon/game/player_motion.h"

namespace platon {
namespace {

constexpr double kMinLandingGain = 0.25;
constexpr int kMaxTurnSteps = 3;  // of the pentatonic scale

bool stands(const PlayerState& player) { return player.ground != Point(); }

// While the button is held, the state says so. After a short press, the player is in the air, upwards, and may no
// longer jump.
bool hasJumped(const PlayerState& before, const PlayerState& now) {
  if (now.jumping != 0) return before.jumping == 0;
  return stands(before) && !stands(now) && now.coyote == 0 && now.velocity.y > 0;
}

// The player was placed anew: the home instance is another one, although no edge was crossed.
bool wasPlaced(const EntityState& before, const EntityState& now) {
  return before.id != now.id && before.crossings == now.crossings;
}

// A hazard leaves the attempt as it is.
bool hasRestarted(const PlayerState& before, const PlayerState& now) {
  return (now.held & Input::kRestart) != 0 || now.startedAt != before.startedAt;
}

// 0 … 1: from the slowest landing that is heard to the fastest usual fall.
double landingStrength(const PlayerState& before) {
  const double speed = -before.velocity.y - PlayerCues::kSoftLanding;
  return std::clamp(speed / (motion::kFallSpeed - PlayerCues::kSoftLanding), 0.0, 1.0);
}

}  // namespace

double PlayerCues::crossingPitch(const Pose& before, const Pose& now) {
  const glm::dvec3 across = now.normal - before.normal * glm::dot(now.normal, before.normal);
  if (glm::length(across) < 1e-9) return 1;
  const double upwards = glm::dot(before.up, glm::normalize(across));
  const int steps = static_cast<int>(std::lround(upwards * kMaxTurnSteps));
  return pentatonic(steps) / pentatonic(0);
}

bool PlayerCues::isNew(Sound sound, std::uint32_t ticks) {
  const bool often = sound == Sound::kJump || sound == Sound::kLand || sound == Sound::kEdge;
  return filter_.passes(static_cast<std::uint32_t>(sound), ticks, often ? kMotionTicks : kEventTicks);
}

std::vector<Cue> PlayerCues::observe(const ObservedPlayer& now) {
  std::vector<Cue> cues;
  if (before_ && now.ticks <= before_->ticks) return cues;
  const bool known = before_ && before_->state.present != 0;
  if (known && now.state.present != 0) {
    addMotion(now, cues);
    addCrossing(now, cues);
    addEvents(now, cues);
  } else {
    heardPart_ = now.entity.part;
    heardPose_ = now.pose;
  }
  before_ = now;
  return cues;
}

void PlayerCues::addMotion(const ObservedPlayer& now, std::vector<Cue>& cues) {
  const PlayerState& before = before_->state;
  if (hasJumped(before, now.state) && isNew(Sound::kJump, now.ticks)) cues.push_back({.sound = Sound::kJump});
  const bool lands = !stands(before) && stands(now.state) && before.velocity.y <= -kSoftLanding;
  if (!lands || !isNew(Sound::kLand, now.ticks)) return;
  const double strength = landingStrength(before);
  cues.push_back({.sound = Sound::kLand,
                  .gain = kMinLandingGain + (1 - kMinLandingGain) * strength,
                  .pitch = 1.25 - 0.35 * strength});
}

// Compares with the face that was heard last: a crossing that reconciliation takes back and predicts anew is no second
// one.
void PlayerCues::addCrossing(const ObservedPlayer& now, std::vector<Cue>& cues) {
  const bool placed = wasPlaced(before_->entity, now.entity);
  const bool crossed = !placed && now.entity.part != heardPart_;
  if (!placed && !crossed) {
    heardPose_ = now.pose;
    return;
  }
  if (crossed) {
    if (!isNew(Sound::kEdge, now.ticks)) return;
    cues.push_back({.sound = Sound::kEdge, .pitch = crossingPitch(heardPose_, now.pose)});
  }
  heardPart_ = now.entity.part;
  heardPose_ = now.pose;
}

void PlayerCues::addEvents(const ObservedPlayer& now, std::vector<Cue>& cues) {
  const PlayerState& before = before_->state;
  const auto add = [&](Sound sound) {
    if (isNew(sound, now.ticks)) cues.push_back({.sound = sound});
  };
  if (wasPlaced(before_->entity, now.entity)) {
    add(hasRestarted(before, now.state) ? Sound::kRestart : Sound::kHazard);
  }
  if (now.state.arrived > before.arrived) add(Sound::kGoal);
  if (now.state.checkpoint != 0 && now.state.checkpoint != before.checkpoint) add(Sound::kCheckpoint);
}

}  // namespace platon
