#include "shared/physics/shape_cache.h"

#include <cstddef>
#include <utility>

namespace platon {
namespace {

constexpr std::size_t kMaxShapes = 1024;

}  // namespace

// `fill` writes a shape and returns whether there is one.
template <class Fill>
const Convex* ShapeCache::find(const Key& key, const Convex& base, Fill&& fill) {
  auto place = entries_.lower_bound(key);
  if (place == entries_.end() || place->first != key) {
    if (unused_.empty()) {
      place = entries_.emplace_hint(place, key, Entry{base});
    } else {
      unused_.back().key() = key;
      place = entries_.insert(place, std::move(unused_.back()));
      unused_.pop_back();
    }
    place->second.isValid = fill(place->second.shape);
  }
  return place->second.isValid ? &*place->second.shape : nullptr;
}

const Convex* ShapeCache::turned(std::uint32_t index, const Convex& base, Angle angle) {
  if (angle == Angle()) return &base;
  return find({index, angle.centidegrees(), 0}, base, [&](std::optional<Convex>& shape) {
    if (shape && base.turnInto(*shape, angle)) return true;
    shape = base.turned(angle);
    return shape.has_value();
  });
}

const Convex* ShapeCache::rotationHull(std::uint32_t index, const Convex& base, Angle angle,
                                       std::int32_t centidegrees) {
  const Convex* before = turned(index, base, angle);
  const Convex* after = turned(index, base, angle + Angle(centidegrees));
  if (before == nullptr || after == nullptr) return nullptr;
  return find({index, angle.centidegrees(), centidegrees}, base, [&](std::optional<Convex>& shape) {
    if (!shape) shape = base;
    shape->becomeHull(*before, *after, work_);
    return true;
  });
}

bool ShapeCache::trim() {
  if (entries_.size() <= kMaxShapes) return false;
  unused_.reserve(unused_.size() + entries_.size());
  while (!entries_.empty()) unused_.push_back(entries_.extract(entries_.begin()));
  return true;
}

}  // namespace platon
