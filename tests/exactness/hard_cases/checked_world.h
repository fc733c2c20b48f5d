#pragma once

#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>

#include "platon/exact/angle.h"
#include "platon/exact/fraction.h"
#include "platon/exact/point.h"
#include "platon/game/level.h"
#include "platon/game/solid.h"
#include "platon/physics/convex.h"
#include "platon/physics/entity.h"
#include "platon/physics/world.h"
#include "tests/exactness/step_check/step_checker.h"
#include "tests/shared/physics/recorded_rules.h"
#include "tests/sim/scene_file.h"

namespace platon {

// Print values in messages of GoogleTest.
inline void PrintTo(Point point, std::ostream* out) { *out << "(" << point.x << ", " << point.y << ")"; }
inline void PrintTo(Angle angle, std::ostream* out) { *out << angle.centidegrees() << " centidegrees"; }
inline void PrintTo(Fraction value, std::ostream* out) { *out << value.numerator << " / " << value.denominator; }

}  // namespace platon

namespace platon::hard_cases {

/// The text of a file in tests/exactness/hard_cases/scenes. Throws std::runtime_error if it cannot be read.
std::string readSceneFile(const std::string& name);

/// A world that checks every tick with the oracle. The first violated invariant is a test failure.
class CheckedWorld {
 public:
  struct Options {
    Convex shape;                         ///< shape of every entity
    std::optional<SolidKind> solid = {};  ///< nothing: a plane
    std::int32_t faceSize = 0;            ///< level units
    RecordedRules rules = {};             ///< name the pierceable segments
  };

  /// `name` is part of the failure message.
  CheckedWorld(std::string name, World initial, Options options);
  CheckedWorld(const CheckedWorld&) = delete;
  CheckedWorld& operator=(const CheckedWorld&) = delete;

  Entity entity(std::uint32_t index = 0) { return {world, index}; }
  Point at(std::uint32_t index = 0) const { return world.entities()[index].position; }
  /// Runs one tick with this velocity, in the frame of its home face, for every entity.
  void tick(Point velocity);
  /// Runs one tick without changing velocities.
  void tick();
  /// Calls `tick(velocity)` until a tick moves nothing, at most `maxTicks` times. Returns the number of ticks that
  /// moved an entity.
  int ticksUntilRest(Point velocity, int maxTicks);
  bool invariantsHold() const { return invariantsHold_; }

  World world;
  const Convex shape;
  RecordedRules rules;  ///< contacts of the last tick; calls since the last take()
  step_check::StepChecker checker;

 private:
  std::string name_;
  bool invariantsHold_ = true;
};

/// The world of a scene file. `platon-sim world` runs the same file.
class HardScene : public CheckedWorld {
 public:
  explicit HardScene(const std::string& name) : HardScene(name, readSceneFile(name)) {}
  HardScene(const std::string& name, std::string_view text);

  const Point velocity;  ///< the velocity in the scene file

 private:
  HardScene(const std::string& name, sim::Scene scene);
};

/// The world of a level file. `platon-sim run --drive push` runs the same file.
class HardLevel : public CheckedWorld {
 public:
  explicit HardLevel(const std::string& name, RecordedRules initialRules = {});

  /// Resets the world and inserts one ball. Returns false if it would overlap a segment.
  bool place(std::uint32_t face, Point position, Angle angle = {});
  bool placeAtStart() { return place(level->startFace, level->start, level->startAngle); }
  /// Runs one tick with this velocity in the ball's own frame.
  void push(Point velocity);

  const std::shared_ptr<const Level> level;

 private:
  HardLevel(const std::string& name, std::shared_ptr<const Level> loaded, RecordedRules initialRules);
};

}  // namespace platon::hard_cases
