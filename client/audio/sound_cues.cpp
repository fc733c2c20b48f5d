#include "client/audio/sound_cues.h"

#include <algorithm>
#include <cmath>

#include "client/audio/hearing.h"
#include "levels/drawing/solid_frame.h"
#include "platon/game/player_motion.h"

namespace platon {
namespace {

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
  const std::vector<Cue> elements =
      elements_.observe(*source.predicted, source.predictedTicks, *source.mesh, local.pose);
  frame.cues.insert(frame.cues.end(), elements.begin(), elements.end());
  frame.roll = rollOf(local.state);
  hearOthers(source, local.pose, frame);
}

void SoundCues::observeOthers(const CueSource& source) {
  for (std::uint32_t slot = 0; slot < source.confirmed->slots(); ++slot) {
    if (slot == source.localSlot) continue;
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
