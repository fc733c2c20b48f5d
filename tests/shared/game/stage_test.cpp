#include "platon/game/stage.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "platon/exact/integer.h"

namespace platon::stage_test {
namespace {

constexpr std::array kKinds = {SolidKind::kTetrahedron, SolidKind::kHexahedron, SolidKind::kOctahedron,
                               SolidKind::kDodecahedron, SolidKind::kIcosahedron};
constexpr std::array<std::int32_t, 4> kSizes = {kMinFaceSize, 333, 480, kMaxFaceSize};

double distance(Point a, Point b) { return std::sqrt(static_cast<double>(squaredLength(b - a))); }

double distanceToLine(Point point, const Segment& line) {
  return std::abs(static_cast<double>(cross(line.b - line.a, point - line.a))) / distance(line.a, line.b);
}

// A point of the line `from` of a warp, in the frame of the part behind it.
Point through(const Warp& warp, Point point) { return rounded(warp.map(precise(point))); }

TEST(StageTest, CutsAre32To57SubunitsFromTheirCorner) {
  for (const SolidKind kind : kKinds) {
    for (const std::int32_t size : kSizes) {
      const auto polygon = facePolygon(kind, size);
      const auto posts = postsOf(kind, size);
      ASSERT_EQ(posts.size(), polygon.size());
      for (std::size_t i = 0; i < posts.size(); ++i) {
        EXPECT_EQ(posts[i].corner, polygon[i]);
        EXPECT_GE(distanceToLine(polygon[i], posts[i].cut), 32.0) << nameOf(kind) << " " << size;
        EXPECT_LE(distance(polygon[i], posts[i].cut.a), 57.0);
        EXPECT_LE(distance(polygon[i], posts[i].cut.b), 57.0);
      }
    }
  }
}

TEST(StageTest, EndsOfCutsAreOnTheEdges) {
  for (const SolidKind kind : kKinds) {
    for (const std::int32_t size : kSizes) {
      const auto polygon = facePolygon(kind, size);
      const auto posts = postsOf(kind, size);
      for (std::size_t i = 0; i < posts.size(); ++i) {
        const Segment begins{polygon[i], polygon[(i + 1) % polygon.size()]};
        const Segment ends{polygon[(i + polygon.size() - 1) % polygon.size()], polygon[i]};
        EXPECT_LE(distanceToLine(posts[i].cut.a, ends), 1.0);
        EXPECT_LE(distanceToLine(posts[i].cut.b, begins), 1.0);
      }
    }
  }
}

TEST(StageTest, EveryPartHasSegmentsThenPostsThenWarps) {
  for (const SolidKind kind : kKinds) {
    const PlatonicSolid& solid = PlatonicSolid::of(kind);
    std::vector<std::vector<Segment>> lines(static_cast<std::size_t>(solid.faces()));
    for (std::size_t face = 0; face < lines.size(); ++face) {
      for (std::size_t i = 0; i <= face; ++i) lines[face].push_back({{0, static_cast<std::int32_t>(i)}, {1000, 0}});
    }
    const World world = buildStage(kind, 480, lines);
    const auto polygon = facePolygon(kind, 480);
    const auto posts = postsOf(kind, 480);
    ASSERT_EQ(world.geometry().parts.size(), lines.size());
    EXPECT_EQ(world.mapFault(), std::nullopt) << nameOf(kind);
    for (std::size_t face = 0; face < lines.size(); ++face) {
      const MapGeometry& part = *world.geometry().parts[face];
      EXPECT_EQ(part.id, face);
      std::vector<Segment> expected = lines[face];
      for (const Post& post : posts) {
        expected.push_back(post.cut);
        expected.push_back({post.corner, post.corner});
      }
      for (std::size_t i = 0; i < polygon.size(); ++i) {
        expected.push_back({polygon[i], polygon[(i + 1) % polygon.size()]});
      }
      EXPECT_EQ(part.segments, expected);
      EXPECT_EQ(part.warps.size(), polygon.size());
    }
  }
}

TEST(StageTest, WarpsMatchTheTopologyOfTheSolid) {
  for (const SolidKind kind : kKinds) {
    const PlatonicSolid& solid = PlatonicSolid::of(kind);
    for (const std::int32_t size : kSizes) {
      const auto polygon = facePolygon(kind, size);
      const World world =
          buildStage(kind, size, std::vector<std::vector<Segment>>(static_cast<std::size_t>(solid.faces())));
      for (int face = 0; face < solid.faces(); ++face) {
        const MapGeometry& part = *world.geometry().parts[static_cast<std::size_t>(face)];
        for (int edge = 0; edge < solid.edgesPerFace(); ++edge) {
          const Warp& warp = part.warps[static_cast<std::size_t>(edge)];
          const PlatonicSolid::Neighbour& behind = solid.neighbour(face, edge);
          EXPECT_EQ(warp.target, behind.face);
          EXPECT_EQ(warp.turn, behind.turn) << nameOf(kind) << " " << size;
          EXPECT_LE(distance(through(warp, warp.from.b), warp.onto.b), 2.0);
          // The centre of the neighbour is on the other side of the edge.
          const Segment mirrored{through(warp, warp.from.a), through(warp, warp.from.b)};
          EXPECT_LT(cross(mirrored.b - mirrored.a, -mirrored.a), 0);
        }
      }
    }
  }
}

TEST(StageTest, CutsContinueAcrossEdges) {
  for (const SolidKind kind : kKinds) {
    const PlatonicSolid& solid = PlatonicSolid::of(kind);
    for (const std::int32_t size : kSizes) {
      const auto posts = postsOf(kind, size);
      const World world =
          buildStage(kind, size, std::vector<std::vector<Segment>>(static_cast<std::size_t>(solid.faces())));
      for (const auto& part : world.geometry().parts) {
        for (std::size_t edge = 0; edge < posts.size(); ++edge) {
          const Warp& warp = part->warps[edge];
          // The cut at the first corner of the edge continues as the cut at the last corner of the neighbour's edge.
          const auto behind = solid.neighbour(static_cast<int>(part->id), static_cast<int>(edge)).edge;
          const std::size_t corner = (std::size_t{behind} + 1) % posts.size();
          EXPECT_LE(distance(through(warp, posts[edge].cut.b), posts[corner].cut.a), 3.0);
        }
      }
    }
  }
}

TEST(StageTest, CornersAreNotFreeForAPlayer) {
  for (const SolidKind kind : kKinds) {
    const auto faces = static_cast<std::size_t>(PlatonicSolid::of(kind).faces());
    const World world = buildStage(kind, 480, std::vector<std::vector<Segment>>(faces));
    const auto polygon = facePolygon(kind, 480);
    for (std::uint32_t face = 0; face < faces; ++face) {
      EXPECT_TRUE(isFreeForPlayer(world, {}, face, {0, 0}, Angle()));
      for (const Point corner : polygon) {
        EXPECT_FALSE(isFreeForPlayer(world, {}, face, corner, Angle()));
        const Point inside(corner.x - corner.x / 64, corner.y - corner.y / 64);
        EXPECT_FALSE(isFreeForPlayer(world, {}, face, inside, Angle()));
      }
      EXPECT_TRUE(isFreeForPlayer(world, {}, face, {0, polygon[0].y}, Angle())) << "edges do not block";
    }
    EXPECT_TRUE(world.entities().empty());
  }
}

}  // namespace
}  // namespace platon::stage_test
