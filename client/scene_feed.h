#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "client/moment.h"
#include "client/scene.h"
#include "client/session.h"
#include "client/stage.h"

namespace platon {

/// Makes what is drawn of a session.
class SceneFeed {
 public:
  /// Nothing while no round is played.
  std::optional<Scene> scene(const Session& session, Moment now);

 private:
  void takeFlashes(const Round& round);

  std::shared_ptr<const Level> level_;
  std::shared_ptr<const Stage> stage_;   // of level_
  std::vector<double> flashes_;          // by slot
};

}  // namespace platon
