#pragma once

#include <string>
#include <vector>

#include "tests/exactness/oracle/random_source.h"

namespace platon::oracle {

/// A random hard scene, as in a scene file: a convex shape among segments that meet, cross, nearly continue each other,
/// form wedges, or are points.
struct Scene {
  Polygon shape;
  std::vector<Segment> lines;
  std::vector<Vec> entities;
  /// About the size of the shape. Choose velocities relative to it.
  std::int64_t scale = 0;
};

/// A scene with at least one entity. No entity overlaps a segment.
Scene randomScene(RandomSource& random);

/// The content of its scene file.
std::string toText(const Scene& scene);

}  // namespace platon::oracle
