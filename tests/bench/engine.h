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

/// Subunits in one metre, wherever an engine counts in metres: a player's diameter is then 1.5 m, as their manuals ask.
inline constexpr double kSubunitsPerMetre = 16384;
/// Steps in one second.
inline constexpr double kStepsPerSecond = 60;

/// A place, subunits.
struct Place {
  double x = 0;
  double y = 0;
};

/// What is given to every engine alike: lines that stand, movers of one convex shape of at most eight vertices.
struct Scene {
  std::vector<Segment> lines;
  Convex shape;
  std::vector<Point> movers;
  double subunitsPerUnit = kSubunitsPerUnit;  ///< a player's radius is 12 units: for what engines measure by it
};

/// A physics engine with a scene in it, used as its manual recommends for a fast character: no gravity of its own, no
/// friction, no bounce, no turning; the caller sets velocities.
class Engine {
 public:
  virtual ~Engine() = default;

  /// Subunits a step, of the next one.
  virtual void setVelocity(std::size_t mover, Place velocity) = 0;
  virtual void step() = 0;
  virtual Place position(std::size_t mover) const = 0;
};

/// A kind of engine, by its name in the report.
struct EngineKind {
  std::string name;
  std::unique_ptr<Engine> (*make)(const Scene& scene);
};

std::unique_ptr<Engine> makePlaton(const Scene& scene);
std::unique_ptr<Engine> makeFloat32(const Scene& scene);
std::unique_ptr<Engine> makeFloat64(const Scene& scene);
std::unique_ptr<Engine> makeBox2d(const Scene& scene);
std::unique_ptr<Engine> makeChipmunk(const Scene& scene);

/// All of them, Platon first.
const std::vector<EngineKind>& engineKinds();

}  // namespace platon::bench
