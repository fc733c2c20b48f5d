#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "client/scene/scene.h"
#include "client/scene/stage_model.h"
#include "client/session/session.h"
#include "protocol/moment.h"

namespace platon {

/// Creates the scene to draw from a session.
class SceneFeed {
 public:
  /// Returns nothing while the session has no round.
  std::optional<Scene> scene(const Session& session, Moment now, std::vector<GhostSource> ghosts = {});

  /// Whether rounds have a time limit.
  void setTimed(bool timed) { timed_ = timed; }
  /// How the local player wants its ball in the next scenes.
  void setOwnBall(const BallChoice& ball) { ownBall_ = ball; }

 private:
  void updateFlashes(const Round& round);
  void updateRoundTrips(const Session& session, Moment now);

  std::shared_ptr<const Level> level_;
  std::shared_ptr<const StageModel> stage_;               // of level_
  std::vector<double> flashes_;                           // by slot
  std::vector<std::optional<std::uint32_t>> roundTrips_;  // by slot, ms
  bool timed_ = true;
  BallChoice ownBall_;
};

}  // namespace platon
