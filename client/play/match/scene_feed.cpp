#include "client/play/match/scene_feed.h"

#include <utility>

namespace platon {

namespace {

// The local player between the last two predicted ticks; at the last one if it was absent in the one before.
InterpolatedPlayer predictedPlayer(const Round& round) {
  const Prediction& prediction = round.prediction();
  const std::span<const EntityState> before = prediction.predictedBefore();
  InterpolatedPlayer local;
  local.now = local.before = snapshotOf(prediction.predicted(), prediction.slot());
  local.fraction = round.predictedFraction();
  if (prediction.slot() < before.size() && before[prediction.slot()].inserted != 0) {
    local.before = snapshotOf(before[prediction.slot()]);
  }
  return local;
}

}  // namespace

// Each player's flash at the tick at which the player is drawn.
void SceneFeed::updateFlashes(const Round& round) {
  const Prediction& prediction = round.prediction();
  const double localTick = double{1} * prediction.predictedTicks() - 1 + round.predictedFraction();
  flashes_.assign(prediction.predicted().slots(), 0);
  for (std::uint32_t slot = 0; slot < flashes_.size(); ++slot) {
    flashes_[slot] =
        round.flashes().brightness(slot, slot == prediction.slot() ? localTick : round.interpolationBuffer().tick());
  }
}

void SceneFeed::updateRoundTrips(const Session& session, Moment now) {
  roundTrips_.resize(session.names().size());
  for (std::uint32_t slot = 0; slot < roundTrips_.size(); ++slot) roundTrips_[slot] = session.roundTripMs(slot, now);
}

std::optional<Scene> SceneFeed::scene(const Session& session, Moment now, std::vector<GhostSource> ghosts) {
  const Round* const round = session.round();
  if (round == nullptr) return std::nullopt;
  const Prediction& prediction = round->prediction();
  if (prediction.confirmed().sharedLevel() != level_) {
    level_ = prediction.confirmed().sharedLevel();
    stage_ = makeStageModel(*level_);
  }
  SceneSource source;
  source.stage = stage_;
  source.game = &prediction.predicted();
  source.roundOver = session.roundEnd() != nullptr;
  source.timed = timed_;
  source.fraction = round->predictedFraction();
  source.others = round->interpolationBuffer().players();
  source.localSlot = prediction.slot();
  source.local = predictedPlayer(*round);
  source.localOffset = prediction.smoothing(now);
  source.names = session.names();
  updateRoundTrips(session, now);
  source.roundTrips = roundTrips_;
  updateFlashes(*round);
  source.flashes = flashes_;
  source.attempt = round->attemptTime();
  source.needsRestart = round->endlessFall().needsHint();
  source.othersCanJoin = true;
  source.ghosts = std::move(ghosts);
  source.ownBall = ownBall_;
  return makeScene(source);
}

}  // namespace platon
