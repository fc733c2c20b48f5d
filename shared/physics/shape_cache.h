#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "platon/exact/angle.h"
#include "platon/physics/convex.h"

namespace platon {

/// Turned shapes and the hulls of turns, made once each. Derived: no result depends on what is cached.
class ShapeCache {
 public:
  /// `base`, which is shape number `index` of its world, turned by `angle`; null when it degenerates there. Valid until
  /// the next `trim`.
  const Convex* turned(std::uint32_t index, const Convex& base, Angle angle);

  /// The hull of the shape turned by `angle` and by `centidegrees` more; null when one of these degenerates.
  const Convex* hullOfTurn(std::uint32_t index, const Convex& base, Angle angle, std::int32_t centidegrees);

  /// Forgets everything when more has gathered than a scene with face turns alone can need (free rotation). True when
  /// it did: then no shape from here is valid any more.
  bool trim();

 private:
  std::map<std::pair<std::uint32_t, std::int32_t>, std::optional<Convex>> shapes_;
  std::map<std::tuple<std::uint32_t, std::int32_t, std::int32_t>, std::optional<Convex>> hulls_;
};

}  // namespace platon
