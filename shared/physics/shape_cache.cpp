#include "shared/physics/shape_cache.h"

namespace platon {
namespace {

constexpr std::size_t kMostShapes = 1024;

}  // namespace

const Convex* ShapeCache::turned(std::uint32_t index, const Convex& base, Angle angle) {
  if (angle == Angle()) return &base;
  const std::pair key{index, angle.hundredths()};
  auto found = shapes_.find(key);
  if (found == shapes_.end()) found = shapes_.emplace(key, base.turned(angle)).first;
  return found->second ? &*found->second : nullptr;
}

bool ShapeCache::trim() {
  if (shapes_.size() <= kMostShapes) return false;
  shapes_.clear();
  return true;
}

}  // namespace platon
