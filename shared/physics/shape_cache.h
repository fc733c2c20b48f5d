#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "shared/exact/angle.h"
#include "shared/physics/convex.h"

namespace platon {

/// Turned shapes, made once per shape and angle. Derived: no result depends on what is cached.
class ShapeCache {
 public:
  /// `base`, which is shape number `index` of its world, turned by `angle`; null when it degenerates there. Valid until
  /// the next `trim`.
  const Convex* turned(std::uint32_t index, const Convex& base, Angle angle);

  /// Forgets everything when more has gathered than a scene with face turns alone can need (free rotation). True when
  /// it did: then no shape from here is valid any more.
  bool trim();

 private:
  std::map<std::pair<std::uint32_t, std::int32_t>, std::optional<Convex>> shapes_;
};

}  // namespace platon
