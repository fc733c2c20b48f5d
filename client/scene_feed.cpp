#include "client/scene_feed.h"

namespace platon {

std::optional<Scene> SceneFeed::scene(const Session& session, Moment now) {
  const Round* const round = session.round();
  if (round == nullptr) return std::nullopt;
  const Prediction& prediction = round->prediction();
  if (prediction.confirmed().sharedLevel() != level_) {
    level_ = prediction.confirmed().sharedLevel();
    stage_ = makeStage(*level_);
  }
  SceneSource source;
  source.stage = stage_;
  source.others = {&prediction.confirmed(), round->confirmedBefore(), round->confirmedFraction(now)};
  source.own = {&prediction.predicted(), prediction.predictedBefore(), round->predictedFraction()};
  source.ownSlot = prediction.slot();
  source.ownOffset = prediction.smoothing(now);
  source.names = session.names();
  return makeScene(source);
}

}  // namespace platon
