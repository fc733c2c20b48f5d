#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "platon/exact/integer.h"
#include "platon/exact/point.h"
#include "platon/physics/convex.h"
#include "platon/physics/segment.h"

namespace platon::bench {

/// Subunits per metre, for engines that use metres. The diameter of a player is then 1.5 m, a size their manuals
/// recommend.
inline constexpr double kSubunitsPerMetre = 16384;
inline constexpr double kStepsPerSecond = 60;

/// A position or a velocity, in subunits or subunits per step.
struct Place {
  double x = 0;
  double y = 0;
};

/// A scene for every engine: static segments, and bodies of one convex shape. For Box2D, a shape has at most
/// kBox2dVertices vertices.
struct Scene {
  std::vector<Segment> segments;
  Convex shape;
  std::vector<Point> bodies;
  /// Resolution of the coordinates; the slop of the float engines depends on it.
  double subunitsPerUnit = kSubunitsPerUnit;
  /// Acceleration against y, subunits per step squared. With gravity, engines let bodies at rest sleep.
  double gravity = 0;
};

/// A physics engine with a scene, set up as its manual recommends for a fast character: without friction, bounce or
/// rotation. The caller sets the velocities.
class Engine {
 public:
  virtual ~Engine() = default;

  /// Sets the velocity for the next step, in subunits per step. In a scene with gravity, x is the speed of walking, and
  /// y the speed with which a jump begins; 0 leaves the vertical velocity to gravity and floors. There, a body whose
  /// velocity is never set stands.
  virtual void setVelocity(std::size_t body, Place velocity) = 0;
  virtual void step() = 0;
  virtual Place position(std::size_t body) const = 0;
};

/// An engine and its name in the report.
struct EngineKind {
  std::string name;
  std::unique_ptr<Engine> (*make)(const Scene& scene);
};

/// Limit of Box2D 2.4 and 3.
inline constexpr std::size_t kBox2dVertices = 8;

std::unique_ptr<Engine> makePlaton(const Scene& scene);
std::unique_ptr<Engine> makeFloat32(const Scene& scene);
std::unique_ptr<Engine> makeFloat64(const Scene& scene);
std::unique_ptr<Engine> makeBox2d(const Scene& scene);
std::unique_ptr<Engine> makeChipmunk(const Scene& scene);

/// All engines, Platon first.
const std::vector<EngineKind>& engineKinds();

/// Platon without the memory of rests, named kComputed: the vertical velocity of all bodies changes by one subunit in
/// every step, so no step equals the last one, and each is computed. Nothing else differs from makePlaton.
std::unique_ptr<Engine> makePlatonComputed(const Scene& scene);
inline constexpr const char* kComputed = "platon-computed";

/// Platon, whose position() is the position and its remainder: the ideal place of the body. Named kIdealPlace.
std::unique_ptr<Engine> makePlatonIdealPlace(const Scene& scene);
inline constexpr const char* kIdealPlace = "platon+remainder";

}  // namespace platon::bench
