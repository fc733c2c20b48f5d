#include "platon/physics/map_part.h"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <utility>

#include "platon/exact/integer.h"
#include "platon/physics/entity.h"
#include "platon/physics/world.h"
#include "shared/physics/step/step_scratch.h"
#include "shared/physics/world_link.h"

namespace platon {
namespace {

void requireCoordinates(std::uint32_t part, Point point) {
  if (isCoordinate(point.x) && isCoordinate(point.y)) return;
  throw std::invalid_argument("map part " + std::to_string(part) + ": the point (" + std::to_string(point.x) + ", " +
                              std::to_string(point.y) +
                              ") is out of range: coordinates must be below 2^29 in magnitude");
}

// Allows 2 subunits for the rounding of the ends; the error of the rotation is below 2^-29 of the length.
bool turnsOnto(Point from, Point onto, Angle turn) {
  const Point error = rotate(from, turn) - onto;
  return squaredLength(error) <= 2 * 2;
}

// Whether `point` is on the left of `border`, or at most 2 subunits on its right. The two subunits are for rounding.
bool isLeftOf(const Segment& border, Point point) {
  const Point along = border.b - border.a;
  return cross(along, point - border.a) >= -2 * std::int64_t{std::max(std::abs(along.x), std::abs(along.y))};
}

// A step takes an entity for beyond a warp when the centre is on the right of it, wherever along its line
// (Instances::containsCentre). So no place of the part may be on the right of a warp, in particular no other warp.
void requireConvexBoundary(std::uint32_t part, const std::vector<Warp>& warps) {
  for (std::size_t i = 0; i < warps.size(); ++i) {
    for (std::size_t k = 0; k < warps.size(); ++k) {
      if (isLeftOf(warps[i].from, warps[k].from.a) && isLeftOf(warps[i].from, warps[k].from.b)) continue;
      throw std::invalid_argument("map part " + std::to_string(part) + ": warp " + std::to_string(k) +
                                  " is on the right of warp " + std::to_string(i) +
                                  ": the warps of a part must bound a convex area on their left; divide the part");
    }
  }
}

bool isNear(PrecisePoint a, PrecisePoint b) {
  return std::abs(a.x - b.x) <= PrecisePoint::kOne && std::abs(a.y - b.y) <= PrecisePoint::kOne;
}

}  // namespace

MapPart::MapPart(World& world, std::uint32_t id) : link_(&world.link()), id_(id) {}

void MapPart::requireOpen() const {
  if (link_->target().geometry().find(id_) == nullptr) return;
  throw std::invalid_argument("map part " + std::to_string(id_) +
                              " is already initialised: add its segments and warps before initialize()");
}

// The world of this part and of the entity, which must exist.
World& MapPart::worldOf(const Entity& entity) const {
  World& world = link_->target();
  if (&entity.world() != &world) {
    throw std::invalid_argument("map part " + std::to_string(id_) + ": entity " + std::to_string(entity.index()) +
                                " belongs to another world: use an entity of the world of this part");
  }
  world.checked(entity.id());
  return world;
}

std::uint32_t MapPart::line(Point p0, Point p1, std::uint32_t tag) {
  requireOpen();
  requireCoordinates(id_, p0);
  requireCoordinates(id_, p1);
  link_->begin(id_);
  segments_.push_back({p0, p1});
  const auto index = static_cast<std::uint32_t>(segments_.size() - 1);
  if (tag != 0) {
    tags_.resize(segments_.size());
    tags_[index] = tag;
  }
  return index;
}

void MapPart::warp(Point p0, Point p1, std::uint32_t targetMap, Point t0, Point t1) {
  warp({p0, p1}, targetMap, {t0, t1}, middle(p0, p1), middle(t0, t1));
}

void MapPart::warp(Segment from, std::uint32_t targetMap, Segment onto, PrecisePoint fromMiddle,
                   PrecisePoint ontoMiddle) {
  requireOpen();
  for (const Point point : {from.a, from.b, onto.a, onto.b}) requireCoordinates(id_, point);
  const std::string where = "map part " + std::to_string(id_) + ", warp " + std::to_string(warps_.size());
  if (from.a == from.b || onto.a == onto.b)
    throw std::invalid_argument(where + ": the two ends of the segment are equal");
  const Angle turn = angleBetween(from.b - from.a, onto.b - onto.a);
  if (!turnsOnto(from.b - from.a, onto.b - onto.a, turn)) {
    throw std::invalid_argument(where +
                                ": the segment and its image differ in length, or the rotation between them is " +
                                "not a whole number of centidegrees");
  }
  if (!isNear(fromMiddle, middle(from.a, from.b)) || !isNear(ontoMiddle, middle(onto.a, onto.b))) {
    throw std::invalid_argument(where + ": a midpoint is more than 1 subunit from the midpoint of the two ends");
  }
  link_->begin(id_);
  warps_.push_back({from, targetMap, onto, turn, fromMiddle, ontoMiddle});
}

void MapPart::initialize() {
  World& world = link_->target();
  world.requireNoStep();
  link_->end(id_);
  requireConvexBoundary(id_, warps_);
  MapGeometry part;
  part.id = id_;
  part.segments = std::move(segments_);
  for (const Warp& warp : warps_) part.segments.push_back(warp.from);
  part.segments.shrink_to_fit();
  part.warps = std::move(warps_);
  part.tags = std::move(tags_);
  part.grid = Grid(part.segments);
  for (EntityCache& cache : world.scratch_->caches)
    cache.rest.forget();  // warps to this part can be passed from now on
  world.geometry_ = withPart(*world.geometry_, std::move(part));
}

void MapPart::insert(Entity& entity, const Point& origin, Angle angle) {
  World& world = worldOf(entity);
  requireCoordinates(id_, origin);
  world.insert(entity.index(), id_, origin, angle);
}

bool MapPart::canPlace(const Entity& entity, Point origin, Angle angle) const {
  return worldOf(entity).canPlace(entity.index(), id_, origin, angle);
}

bool MapPart::canPlace(const Convex& shape, Point origin, Angle angle) const {
  const World& world = link_->target();
  return world.canPlace(id_, shape, origin, angle, world.rules());
}

void MapPart::erase(Entity& entity) { worldOf(entity).erase(entity.index(), id_); }

}  // namespace platon
