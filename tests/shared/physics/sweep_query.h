#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "platon/physics/sweep.h"

namespace platon {

/// The input of one sweep test.
struct SweepQuery {
  std::vector<Point> shape;
  Point position;
  Point displacement;
  Segment segment;
};

inline std::optional<Hit> answer(const SweepQuery& query, std::int32_t margin = 0) {
  const Convex shape(query.shape);
  Sweep sweep;
  sweep.start(shape, query.position, query.displacement, margin);
  return sweep.against(query.segment);
}

}  // namespace platon
