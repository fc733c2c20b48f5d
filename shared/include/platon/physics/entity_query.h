#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "platon/exact/fraction.h"
#include "platon/exact/point.h"
#include "platon/physics/convex.h"
#include "platon/physics/entity_state.h"
#include "platon/physics/world.h"

namespace platon {

/// An instance of an entity that a query has found in a map part.
struct FoundInstance {
  EntityId entity;             ///< Entity(world, entity) is its handle
  std::uint16_t instance = 0;  ///< id of the instance
  bool home = false;           ///< whether it is the home instance
  Point position;              ///< in the frame of the part, subunits
  Angle angle;                 ///< rotation of the shape in the frame of the part
};

/// An instance that a ray meets. The shape is open: touching does not count.
struct InstanceHit {
  FoundInstance found;
  Fraction time;  ///< at which the ray enters the shape, as a fraction of the displacement, in [0, 1)
  Point normal;   ///< of the edge by which it enters, out of the shape; (0, 0) when the ray starts inside of it
};

/// Finds entities by place. Exact, like the queries of query.h, and deterministic. Sees one map part: an entity near an
/// edge has an instance in each part that its shape reaches, and is found in each of them.
///
/// Holds the rotated shapes that it needs from one query to the next, so that a repeated query does not allocate. Any
/// number of them may ask a world at the same time. Takes time for every entity of the world, and more for those whose
/// instances are near. All functions throw std::invalid_argument as the functions of query.h do.
class EntityQuery {
 public:
  EntityQuery();
  EntityQuery(EntityQuery&&) noexcept;
  EntityQuery& operator=(EntityQuery&&) noexcept;
  ~EntityQuery();

  /// Replaces `found` by all instances in the part that overlap the shape at `position`: in the order of the indices of
  /// their entities, of one entity the home instance first.
  void overlapping(const World& world, std::uint32_t part, const Convex& shape, Point position,
                   std::vector<FoundInstance>& found);
  /// Replaces `hits` by all instances in the part that the ray from `from` to `from + displacement` meets, in the order
  /// of time, then as above.
  void onRay(const World& world, std::uint32_t part, Point from, Point displacement, std::vector<InstanceHit>& hits);

 private:
  template <class Visit>
  void forEachNear(const World& world, std::uint32_t part, const Box& area, Visit&& visit);

  struct Shapes;
  std::unique_ptr<Shapes> shapes_;
};

}  // namespace platon
