#include "platon/physics/entity_query.h"

#include <algorithm>
#include <optional>
#include <span>

#include "platon/physics/query.h"
#include "platon/physics/sweep.h"
#include "shared/physics/query/query_checks.h"
#include "shared/physics/shape_cache.h"

namespace platon {
namespace {

// A box that contains the shape at `position`, however it is rotated.
Box reachOf(const Convex& shape, Point position) {
  const auto [low, high] = shape.bounds();
  const std::int32_t farthest = std::max({-low.x, -low.y, high.x, high.y});
  // A rotated vertex is at most sqrt(2) times as far along an axis. The sum is below 2^31.
  const std::int32_t reach = farthest + farthest / 2 + 1;
  return Box{position, position}.grown(reach);
}

}  // namespace

// The rotated shapes of one world, and its unrotated ones, by which another world is recognised.
struct EntityQuery::Shapes {
  ShapeCache cache;
  std::vector<std::optional<Convex>> bases;  // by index of the world's shape

  const Convex* turned(std::uint32_t index, const Convex& base, Angle angle) {
    if (bases.size() <= index) bases.resize(index + 1);
    if (bases[index] && *bases[index] != base) {
      cache = {};
      bases.assign(index + 1, std::nullopt);
    }
    if (!bases[index]) bases[index] = base;
    return cache.turned(index, *bases[index], angle);
  }
};

EntityQuery::EntityQuery() : shapes_(std::make_unique<Shapes>()) {}
EntityQuery::EntityQuery(EntityQuery&&) noexcept = default;
EntityQuery& EntityQuery::operator=(EntityQuery&&) noexcept = default;
EntityQuery::~EntityQuery() = default;

// Calls `visit(instance, shape)` for every instance in the part whose shape may reach the area.
template <class Visit>
void EntityQuery::forEachNear(const World& world, std::uint32_t part, const Box& area, Visit&& visit) {
  shapes_->cache.trim();
  const WorldState& state = world.state();
  std::size_t next = 0;
  for (std::uint32_t i = 0; i < state.entities.size(); ++i) {
    const EntityState& entity = state.entities[i];
    const auto further = std::span(state.instances).subspan(next, entity.instances);
    next += entity.instances;
    if (entity.inserted == 0) continue;
    const Convex& base = world.shapeOf(i);
    const auto offer = [&](const FoundInstance& found) {
      if (!reachOf(base, found.position).overlaps(area)) return;
      if (const Convex* shape = shapes_->turned(entity.shape, base, found.angle)) visit(found, *shape);
    };
    if (entity.part == part) offer({world.idOf(i), entity.id, true, entity.position, entity.angle});
    for (const InstanceState& instance : further) {
      if (instance.part != part) continue;
      offer({world.idOf(i), instance.id, false, platon::positionOf(entity, instance), instance.angle});
    }
  }
}

void EntityQuery::overlapping(const World& world, std::uint32_t part, const Convex& shape, Point position,
                              std::vector<FoundInstance>& found) {
  requirePath(position, {});
  partOf(world, part);
  found.clear();
  const Box area{position + shape.bounds().low, position + shape.bounds().high};
  forEachNear(world, part, area, [&](const FoundInstance& instance, const Convex& other) {
    if (overlap(shape, position, other, instance.position)) found.push_back(instance);
  });
}

// The ray meets the shape where the shape, moved the other way, meets the start of the ray.
void EntityQuery::onRay(const World& world, std::uint32_t part, Point from, Point displacement,
                        std::vector<InstanceHit>& hits) {
  requirePath(from, displacement);
  partOf(world, part);
  hits.clear();
  Sweep sweep;
  forEachNear(world, part, Box{from, from}.swept(displacement),
              [&](const FoundInstance& instance, const Convex& shape) {
                sweep.start(shape, instance.position, -displacement);
                if (const auto hit = sweep.against({from, from})) hits.push_back({instance, hit->time, -hit->normal});
              });
  // Instances at equal times stay in the order in which they were found. Sorts by insertion, because std::stable_sort
  // allocates: a ray meets few instances.
  for (auto last = hits.begin(); last != hits.end(); ++last) {
    const auto place = std::upper_bound(hits.begin(), last, *last,
                                        [](const InstanceHit& a, const InstanceHit& b) { return a.time < b.time; });
    std::rotate(place, last, last + 1);
  }
}

}  // namespace platon
