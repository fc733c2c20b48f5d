#include "tests/exactness/oracle/trace/shape_library.h"

#include "tests/exactness/oracle/trace/solid_model.h"

namespace platon::oracle {
namespace {

constexpr long double kMaxRounding = 1;

}  // namespace

ShapeLibrary::ShapeLibrary(const Polygon& base, TraceReport& report)
    : base_(base), report_(report), known_(static_cast<std::size_t>(kTurn)) {}

bool ShapeLibrary::isRotatedBase(std::size_t angle, const Polygon& polygon) const {
  if (polygon.size() != base_.size()) return false;
  const Isometry turn(static_cast<std::int64_t>(angle), {}, {});
  const auto fits = [&](std::size_t shift) {
    for (std::size_t i = 0; i < base_.size(); ++i)
      if (distance(turn.apply(toReal(base_[i])), toReal(polygon[(i + shift) % base_.size()])) > kMaxRounding)
        return false;
    return true;
  };
  // A rotation may map the shape onto itself. A trace may then omit the shape, although its first vertex differs.
  for (std::size_t shift = 0; shift < base_.size(); ++shift)
    if (fits(shift)) return true;
  return false;
}

const RotatedShape& ShapeLibrary::add(std::size_t angle, const Polygon& polygon) {
  if (!isStrictlyConvex(polygon)) report_.violate("shape", "not strictly convex at angle " + std::to_string(angle));
  if (!isRotatedBase(angle, polygon))
    report_.violate("shape", "not the base shape rotated by angle " + std::to_string(angle));
  known_[angle] = std::make_unique<RotatedShape>(RotatedShape{polygon, boxOf(polygon)});
  return *known_[angle];
}

const RotatedShape& ShapeLibrary::of(const TraceInstance& instance) {
  const auto angle = static_cast<std::size_t>(normalizedAngle(instance.angle));
  const Polygon& polygon = instance.shape.empty() ? base_ : instance.shape;
  if (known_[angle] == nullptr) {
    if (instance.shape == base_) report_.violate("format", "the given shape equals that of the header");
    return add(angle, polygon);
  }
  if (known_[angle]->polygon != polygon)
    report_.violate("shape", "differs from the earlier shape at angle " + std::to_string(angle));
  return *known_[angle];
}

}  // namespace platon::oracle
