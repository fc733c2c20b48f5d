#include "platon/physics/map_geometry.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

namespace platon {
namespace {

auto lowerBound(const Geometry& geometry, std::uint32_t id) {
  return std::lower_bound(geometry.parts.begin(), geometry.parts.end(), id,
                          [](const auto& part, std::uint32_t wanted) { return part->id < wanted; });
}

Segment reversed(const Segment& segment) { return {segment.b, segment.a}; }

}  // namespace

PrecisePoint Warp::map(PrecisePoint point) const { return ontoMiddle + rotated(point - fromMiddle, rotation); }

PrecisePoint Warp::mapBack(PrecisePoint point) const {
  return fromMiddle + rotated(point - ontoMiddle, rotationOf(-turn));
}

const MapGeometry* Geometry::find(std::uint32_t id) const {
  if (id < parts.size() && parts[id]->id == id) return parts[id].get();  // fast path: ids usually count from 0
  const auto found = lowerBound(*this, id);
  return found != parts.end() && (*found)->id == id ? found->get() : nullptr;
}

bool operator==(const Geometry& a, const Geometry& b) {
  return std::equal(a.parts.begin(), a.parts.end(), b.parts.begin(), b.parts.end(),
                    [](const auto& x, const auto& y) { return x == y || *x == *y; });
}

std::optional<std::uint16_t> Geometry::reverseWarp(std::uint32_t partId, const Warp& warp) const {
  const MapGeometry* target = find(warp.target);
  if (target == nullptr) return std::nullopt;
  for (std::size_t i = 0; i < target->warps.size(); ++i) {
    const Warp& back = target->warps[i];
    if (back.target == partId && back.from == reversed(warp.onto) && back.onto == reversed(warp.from)) {
      return static_cast<std::uint16_t>(i);
    }
  }
  return std::nullopt;
}

std::shared_ptr<const Geometry> withPart(const Geometry& geometry, MapGeometry part) {
  if (geometry.find(part.id) != nullptr) {
    throw std::invalid_argument("map part " + std::to_string(part.id) +
                                " is already initialised: call initialize() once, and give another part another id");
  }
  auto extended = std::make_shared<Geometry>(geometry);
  const auto place = extended->parts.begin() + (lowerBound(geometry, part.id) - geometry.parts.begin());
  extended->parts.insert(place, std::make_shared<const MapGeometry>(std::move(part)));
  return extended;
}

}  // namespace platon
