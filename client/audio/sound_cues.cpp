#include "client/audio/sound_cues.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/geometric.hpp>

#include "levels/drawing/solid_frame.h"
#include "platon/game/input.h"
#include "platon/game/player_motion.h"

namespace platon {
namespace {

// Whether the key is taken, the door or the timed segment open, or the plate pressed. A plate of which the key is taken
// keeps still.
bool isOn(const Game& game, const Element& element) {
  switch (element.kind) {
    case ElementKind::kKey:
      return game.isTaken(element);
    case ElementKind::kDoor:
    case ElementKind::kTimed:
      return game.open().has(element);
    case ElementKind::kPlate:
      return (game.openDoors() & element.bit()) != 0 && !game.isTaken(element);
    case ElementKind::kOneway:
    case ElementKind::kUp:
    case ElementKind::kHazard:
    case ElementKind::kCheckpoint:
      return false;
  }
  return false;
}

// A key that is there again makes no sound.
std::optional<Sound> soundOf(ElementKind kind, bool on) {
  switch (kind) {
    case ElementKind::kKey:
      return on ? std::optional(Sound::kKey) : std::nullopt;
    case ElementKind::kDoor:
      return on ? Sound::kDoorOpens : Sound::kDoorCloses;
    case ElementKind::kPlate:
      return on ? Sound::kPlateDown : Sound::kPlateUp;
    case ElementKind::kTimed:
      return on ? Sound::kFenceDown : Sound::kFenceUp;
    case ElementKind::kOneway:
    case ElementKind::kUp:
    case ElementKind::kHazard:
    case ElementKind::kCheckpoint:
      return std::nullopt;
  }
  return std::nullopt;
}

glm::dvec3 placeInSpace(const SolidMesh& mesh, const Element& element) {
  return mesh.toWorld(static_cast<int>(element.face), toUnits(placeOf(element)));
}

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

ObservedPlayer observed(const Game& game, std::uint32_t ticks, std::uint32_t slot, const SolidMesh& mesh) {
  const EntityState& entity = game.world().entities()[slot];
  return {ticks, game.player(slot), entity,
          mesh.pose(static_cast<int>(entity.part), toUnits(entity.position), toRadians(entity.angle))};
}

bool isPresent(const Game& game, std::uint32_t slot) { return slot < game.slots() && game.player(slot).present != 0; }

double rollOf(const PlayerState& player) {
  if (player.ground == Point()) return 0;
  const glm::dvec2 velocity = toUnits(player.velocity);
  const double run = toUnits(Point(motion::kRunSpeed, 0)).x;
  return std::min(1.0, std::hypot(velocity.x, velocity.y) / run);
}

}  // namespace

Heard hear(const Pose& listener, glm::dvec3 place) {
  const glm::dvec3 way = place - listener.position;
  const double distance = glm::length(way) / kHalfGainDistance;
  const double side = glm::dot(way, glm::cross(listener.up, listener.normal)) / kFullPanDistance;
  return {1 / (1 + distance * distance), std::clamp(side, -1.0, 1.0)};
}

std::vector<Cue> ElementCues::observe(const Game& game, std::uint32_t ticks, const SolidMesh& mesh,
                                      const Pose& listener) {
  const std::vector<Element>& elements = game.level().elements;
  if (elements.empty() || (!before_.empty() && ticks <= newest_)) return {};
  std::vector<std::uint8_t> now;
  for (const Element& element : elements) now.push_back(isOn(game, element) ? 1 : 0);
  std::vector<Cue> loudest;
  std::vector<std::uint32_t> keys;  // of `loudest`: sound and number
  for (std::size_t i = 0; i < now.size() && !before_.empty(); ++i) {
    const std::optional<Sound> sound = now[i] != before_[i] ? soundOf(elements[i].kind, now[i] != 0) : std::nullopt;
    if (!sound) continue;
    const Heard heard = hear(listener, placeInSpace(mesh, elements[i]));
    const Cue cue{.sound = *sound, .gain = heard.gain, .pan = heard.pan};
    const std::uint32_t key = static_cast<std::uint32_t>(*sound) * kMaxDoorNumbers + elements[i].number;
    const auto known = std::find(keys.begin(), keys.end(), key);
    if (known != keys.end()) {
      Cue& other = loudest[static_cast<std::size_t>(known - keys.begin())];
      if (other.gain < cue.gain) other = cue;
    } else if (filter_.passes(key, ticks, kEventTicks)) {
      keys.push_back(key);
      loudest.push_back(cue);
    }
  }
  before_ = std::move(now);
  newest_ = ticks;
  return loudest;
}

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

namespace {

bool contains(const std::vector<std::uint32_t>& slots, std::uint32_t slot) {
  return std::find(slots.begin(), slots.end(), slot) != slots.end();
}

}  // namespace

SoundFrame SoundCues::update(const CueSource* source) {
  SoundFrame frame;
  if (source == nullptr) return frame;
  if (round_ != source->round) startRound(*source, frame);
  frame.solid = source->mesh->solid().kind();
  players_.resize(std::max<std::size_t>(players_.size(), kMaxPlayers));
  observeOthers(*source);
  hearLocal(*source, frame);
  countDown(*source, frame);
  return frame;
}

// The first round of a match starts without a sound: nobody has waited for it.
void SoundCues::startRound(const CueSource& source, SoundFrame& frame) {
  if (counted_) frame.cues.push_back({.sound = Sound::kRoundStart});
  *this = SoundCues();
  round_ = source.round;
}

void SoundCues::hearLocal(const CueSource& source, SoundFrame& frame) {
  if (!isPresent(*source.predicted, source.localSlot)) return;
  const ObservedPlayer local = observed(*source.predicted, source.predictedTicks, source.localSlot, *source.mesh);
  for (Cue& cue : players_[source.localSlot].observe(local)) {
    cue.slot = source.localSlot;
    frame.celebrates = frame.celebrates || cue.sound == Sound::kGoal;
    frame.cues.push_back(cue);
  }
  for (const std::uint32_t slot : source.companions) {
    if (!isPresent(*source.predicted, slot)) continue;
    for (Cue& cue : players_[slot].observe(observed(*source.predicted, source.predictedTicks, slot, *source.mesh))) {
      cue.slot = slot;
      frame.cues.push_back(cue);
    }
  }
  const std::vector<Cue> elements =
      elements_.observe(*source.predicted, source.predictedTicks, *source.mesh, local.pose);
  frame.cues.insert(frame.cues.end(), elements.begin(), elements.end());
  frame.roll = rollOf(local.state);
  hearOthers(source, local.pose, frame);
}

void SoundCues::observeOthers(const CueSource& source) {
  for (std::uint32_t slot = 0; slot < source.confirmed->slots(); ++slot) {
    if (slot == source.localSlot || contains(source.companions, slot)) continue;
    const ObservedPlayer player = observed(*source.confirmed, source.confirmedTicks, slot, *source.mesh);
    for (Cue& cue : players_[slot].observe(player)) {
      cue.slot = slot;
      pending_.push_back({double{1} * source.confirmedTicks, cue, player.pose.position});
    }
  }
}

void SoundCues::hearOthers(const CueSource& source, const Pose& listener, SoundFrame& frame) {
  std::erase_if(pending_, [&](const Pending& pending) {
    if (pending.tick > source.othersTick) return false;
    const Heard heard = hear(listener, pending.place);
    Cue cue = pending.cue;
    cue.gain *= kOthersGain * heard.gain;
    cue.pan = heard.pan;
    if (cue.gain >= kMinGain) frame.cues.push_back(cue);
    return true;
  });
}

// Counts the last seconds of the round, unless the player has arrived, and those before the next one.
void SoundCues::countDown(const CueSource& source, SoundFrame& frame) {
  const bool waits = source.over;
  if (waits ? !source.nextRoundSeconds : !source.timed) return;
  const double seconds = waits ? *source.nextRoundSeconds : double{1} * source.predicted->ticksLeft() / kTicksPerSecond;
  const int left = static_cast<int>(std::ceil(seconds));
  const bool arrived =
      isPresent(*source.predicted, source.localSlot) && source.predicted->player(source.localSlot).arrived != 0;
  const bool counts = waits || !arrived;
  if (left < secondsLeft_ && left >= 1 && left <= (waits ? kNextCountdown : kRoundCountdown) && counts) {
    frame.cues.push_back({.sound = Sound::kCountdown, .gain = 0.7});
    counted_ = counted_ || waits;
  }
  secondsLeft_ = left;
}

}  // namespace platon
