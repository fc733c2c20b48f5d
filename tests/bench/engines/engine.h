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

/// A scene for every engine: static segments, and bodies of one convex shape with at most eight vertices.
struct Scene {
  std::vector<Segment> segments;
  Convex shape;
  std::vector<Point> bodies;
  /// Resolution of the coordinates; the slop of the float engines depends on it.
  double subunitsPerUnit = kSubunitsPerUnit;
};

/// A physics engine with a scene, set up as its manual recommends for a fast character: without gravity, friction,
/// bounce or rotation. The caller sets the velocities.
class Engine {
 public:
  virtual ~Engine() = default;

  /// Sets the velocity for the next step, in subunits per step.
  virtual void setVelocity(std::size_t body, Place velocity) = 0;
  virtual void step() = 0;
  virtual Place position(std::size_t body) const = 0;
};

/// An engine and its name in the report.
struct EngineKind {
  std::string name;
  std::unique_ptr<Engine> (*make)(const Scene& scene);
};

std::unique_ptr<Engine> makePlaton(const Scene& scene);
std::unique_ptr<Engine> makeFloat32(const Scene& scene);
std::unique_ptr<Engine> makeFloat64(const Scene& scene);
std::unique_ptr<Engine> makeBox2d(const Scene& scene);
std::unique_ptr<Engine> makeChipmunk(const Scene& scene);

/// All engines, Platon first.
const std::vector<EngineKind>& engineKinds();

}  // namespace platon::bench
