#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "platon/exact/angle.h"
#include "platon/physics/convex.h"

namespace platon {

/// Cache of rotated shapes and of the hulls used to test rotations. Derived state; influences speed only.
class ShapeCache {
 public:
  /// `base`, the world's shape number `index`, rotated by `angle`. Null when the result is degenerate. Valid until the
  /// cache is cleared by `trim`.
  const Convex* turned(std::uint32_t index, const Convex& base, Angle angle);

  /// The convex hull of the shape rotated by `angle` and of the shape rotated by `angle` + `centidegrees`. Null when
  /// one of these is degenerate.
  const Convex* rotationHull(std::uint32_t index, const Convex& base, Angle angle, std::int32_t centidegrees);

  /// Clears the cache when it holds more than 1024 shapes, which only free rotation can cause. Returns whether it did;
  /// all pointers from this cache are invalid then.
  bool trim();

 private:
  std::map<std::pair<std::uint32_t, std::int32_t>, std::optional<Convex>> shapes_;
  std::map<std::tuple<std::uint32_t, std::int32_t, std::int32_t>, std::optional<Convex>> hulls_;
};

}  // namespace platon
