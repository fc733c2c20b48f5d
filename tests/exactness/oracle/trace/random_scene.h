#pragma once

#include <string>
#include <vector>

#include "tests/exactness/oracle/random_source.h"

namespace platon::oracle {

/// A scene in the form of a scene file's content, made to be hard: any convex shape among lines that meet, cross,
/// nearly continue each other, narrow to wedges, or are single points.
struct Scene {
  Polygon shape;
  std::vector<Segment> lines;
  std::vector<Vec> entities;
  /// About the shape's own size; velocities should be measured by it.
  std::int64_t scale = 0;
};

/// A scene with at least one entity, all of them free.
Scene makeScene(RandomSource& random);

/// The content of its scene file.
std::string toText(const Scene& scene);

}  // namespace platon::oracle
