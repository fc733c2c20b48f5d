// A ball rolls straight on over the faces of a hexahedron, until it has been on all of them.
#include <cstdint>
#include <cstdio>
#include <set>
#include <vector>

#include "platon/game/solid.h"
#include "platon/physics/entity.h"
#include "platon/physics/map_part.h"
#include "platon/physics/world.h"

using platon::Angle;
using platon::Point;

constexpr auto kKind = platon::SolidKind::kHexahedron;
constexpr std::int32_t kFaceSize = 200;  // units; the origin of a face is its centre
constexpr std::int32_t kRadius = 5120;   // subunits

// Each face is a map part. A warp along each of its edges says which face continues it, and where the edge is there.
platon::World hexahedron() {
  platon::World world;
  const auto& solid = platon::PlatonicSolid::of(kKind);
  const std::vector<Point> corners = platon::facePolygon(kKind, kFaceSize);
  const auto corner = [&](int i) { return corners[static_cast<std::size_t>(i) % corners.size()]; };
  for (int face = 0; face < solid.faces(); ++face) {
    platon::MapPart part(world, static_cast<std::uint32_t>(face));
    for (int edge = 0; edge < solid.edgesPerFace(); ++edge) {
      const auto& behind = solid.neighbour(face, edge);
      part.line(corner(edge), corner(edge));  // a point: no body may cover a corner of the solid
      part.warp(corner(edge), corner(edge + 1), behind.face, corner(behind.edge + 1), corner(behind.edge));
    }
    part.initialize();
  }
  return world;
}

// A regular polygon with 24 vertices.
platon::Convex ball() {
  std::vector<Point> vertices;
  for (int i = 0; i < 24; ++i) vertices.push_back(platon::rotate(Point(kRadius, 0), Angle::degrees(15 * i)));
  return platon::Convex(vertices);
}

int main() {
  platon::World world = hexahedron();
  platon::Entity rolling(world, ball());
  platon::MapPart(world, 0).insert(rolling, {0, 0}, Angle());
  rolling.setVelocity(
      {1000, 700});  // in the frame of the face; it turns with the frame when the ball goes over an edge
  std::set<std::uint32_t> seen{rolling.part()};
  std::printf("starts on face %u\n", rolling.part());
  for (int tick = 1; seen.size() < 6 && tick <= 10000; ++tick) {
    const std::uint32_t before = rolling.part();
    rolling.rotate(-1366);  // centidegrees: 1220 subunits of a circumference of 32170
    world.solve();
    if (rolling.part() == before) continue;
    seen.insert(rolling.part());
    std::printf("tick %d: on face %u at (%d, %d)\n", tick, rolling.part(), rolling.position().x, rolling.position().y);
  }
}

// It prints:
// starts on face 0
// tick 103: on face 1 at (-101800, 72100)
// tick 147: on face 4 at (101900, -57800)
// tick 308: on face 2 at (10800, 101600)
// tick 439: on face 3 at (-102300, -29400)
// tick 513: on face 5 at (-101400, -50500)
