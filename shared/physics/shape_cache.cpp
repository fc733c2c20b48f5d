#include "shared/physics/shape_cache.h"

#include <vector>

namespace platon {
namespace {

constexpr std::size_t kMaxShapes = 1024;

Convex hullOf(const Convex& a, const Convex& b) {
  std::vector<Point> points = a.vertices();
  points.insert(points.end(), b.vertices().begin(), b.vertices().end());
  return Convex(convexHull(std::move(points)));
}

}  // namespace

const Convex* ShapeCache::turned(std::uint32_t index, const Convex& base, Angle angle) {
  if (angle == Angle()) return &base;
  const std::pair key{index, angle.centidegrees()};
  auto found = shapes_.find(key);
  if (found == shapes_.end()) found = shapes_.emplace(key, base.turned(angle)).first;
  return found->second ? &*found->second : nullptr;
}

const Convex* ShapeCache::rotationHull(std::uint32_t index, const Convex& base, Angle angle,
                                       std::int32_t centidegrees) {
  const std::tuple key{index, angle.centidegrees(), centidegrees};
  auto found = hulls_.find(key);
  if (found == hulls_.end()) {
    const Convex* before = turned(index, base, angle);
    const Convex* after = turned(index, base, angle + Angle(centidegrees));
    found = hulls_.emplace(key, before && after ? std::optional(hullOf(*before, *after)) : std::nullopt).first;
  }
  return found->second ? &*found->second : nullptr;
}

bool ShapeCache::trim() {
  if (shapes_.size() + hulls_.size() <= kMaxShapes) return false;
  shapes_.clear();
  hulls_.clear();
  return true;
}

}  // namespace platon
