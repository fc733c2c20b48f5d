#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <tuple>
#include <vector>

#include "platon/exact/angle.h"
#include "platon/physics/convex.h"

namespace platon {

/// Cache of rotated shapes and of the hulls used to test rotations. Derived state; influences speed only. Keeps the
/// memory of the shapes that it clears, so that shapes turned by ever new angles do not allocate.
class ShapeCache {
 public:
  /// `base`, the world's shape number `index`, rotated by `angle`. Null when the result is degenerate. Valid until the
  /// cache is cleared by `trim`.
  const Convex* turned(std::uint32_t index, const Convex& base, Angle angle);

  /// The convex hull of the shape rotated by `angle` and of the shape rotated by `angle` + `centidegrees`. Null when
  /// one of these is degenerate. Requires centidegrees != 0.
  const Convex* rotationHull(std::uint32_t index, const Convex& base, Angle angle, std::int32_t centidegrees);

  /// Clears the cache when it holds more than 1024 shapes, which only free rotation can cause. Returns whether it did;
  /// all pointers from this cache are invalid then.
  bool trim();

 private:
  // Shape, angle, and for a hull the centidegrees by which the shape turns, which are not 0.
  using Key = std::tuple<std::uint32_t, std::int32_t, std::int32_t>;
  struct Entry {
    std::optional<Convex> shape;
    bool isValid = false;
  };
  using Entries = std::map<Key, Entry>;

  template <class Fill>
  const Convex* find(const Key& key, const Convex& base, Fill&& fill);

  Entries entries_;
  std::vector<Entries::node_type> unused_;
  std::vector<Point> work_;
};

}  // namespace platon
