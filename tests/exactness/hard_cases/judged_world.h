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
#include "tests/exactness/judge/step_checker.h"
#include "tests/shared/physics/recorded_rules.h"
#include "tests/sim/scene_file.h"

namespace platon {

// For messages of GoogleTest.
inline void PrintTo(Point point, std::ostream* out) { *out << "(" << point.x << ", " << point.y << ")"; }
inline void PrintTo(Angle angle, std::ostream* out) { *out << angle.centidegrees() << " / 100 degrees"; }
inline void PrintTo(Fraction value, std::ostream* out) { *out << value.numerator << " / " << value.denominator; }

}  // namespace platon

namespace platon::hard_cases {

/// The text of a file below tests/exactness/hard_cases/scenes. Throws std::runtime_error when there is none.
std::string readCase(const std::string& name);

/// A world every tick of which goes before the oracle: a broken law is a test failure, told once.
class JudgedWorld {
 public:
  /// The figures that the checker needs besides the world.
  struct Setting {
    Convex shape;                         ///< of every entity
    std::optional<SolidKind> solid = {};  ///< none: a plane
    std::int32_t faceSize = 0;            ///< level units
    RecordedRules rules = {};             ///< what is pierceable
  };

  /// `name` is told with a failure.
  JudgedWorld(std::string name, World made, Setting setting);
  JudgedWorld(const JudgedWorld&) = delete;
  JudgedWorld& operator=(const JudgedWorld&) = delete;

  Entity entity(std::uint32_t index = 0) { return {world, index}; }
  Point at(std::uint32_t index = 0) const { return world.entities()[index].position; }
  /// One tick, every entity with this velocity in its home's frame.
  void tick(Point velocity);
  /// One tick without setting any velocity.
  void tick();
  /// Calls `tick(velocity)` until nothing moves, at most so often; the number of ticks that moved anything.
  int ticksToRest(Point velocity, int most);
  bool lawful() const { return lawful_; }

  World world;
  const Convex shape;
  RecordedRules rules;  ///< contacts of the last tick, calls since they were taken
  judge::StepChecker checker;

 private:
  std::string name_;
  bool lawful_ = true;
};

/// A scene file: run it by `platon-sim world`.
class HardScene : public JudgedWorld {
 public:
  explicit HardScene(const std::string& name) : HardScene(name, readCase(name)) {}
  HardScene(const std::string& name, std::string_view text);

  const Point velocity;  ///< the scene's

 private:
  HardScene(const std::string& name, sim::Scene scene);
};

/// A level file: run it by `platon-sim run --drive push`.
class HardLevel : public JudgedWorld {
 public:
  explicit HardLevel(const std::string& name, RecordedRules given = {});

  /// Forgets everything and puts a ball there, alone. False when it is not free there.
  bool place(std::uint32_t face, Point position, Angle angle = {});
  bool placeAtStart() { return place(level->startFace, level->start, level->startAngle); }
  /// One tick with this velocity in the ball's own frame.
  void push(Point velocity);

  const std::shared_ptr<const Level> level;

 private:
  HardLevel(const std::string& name, std::shared_ptr<const Level> loaded, RecordedRules given);
};

}  // namespace platon::hard_cases
