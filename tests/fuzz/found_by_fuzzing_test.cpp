// Faults that the fuzzers found, one test each.
#include <gtest/gtest.h>

#include <map>

#include "platon/game/stage.h"
#include "platon/physics/entity.h"
#include "platon/physics/map_part.h"
#include "protocol/transport/enet_layer.h"
#include "protocol/transport/sealed_channel.h"
#include "tests/exactness/step_check/step_checker.h"
#include "tests/fuzz/fuzz_scene.h"
#include "tests/net/support/raw_content.h"

namespace platon::fuzz::found_by_fuzzing_test {
namespace {

constexpr std::int32_t kFaceSize = 240;
constexpr std::int32_t kUnit = kSubunitsPerUnit;

FuzzScene stageOf(SolidKind kind, std::vector<std::vector<Segment>> lines, Convex shape) {
  lines.resize(static_cast<std::size_t>(PlatonicSolid::of(kind).faces()));
  std::vector<std::size_t> counts;
  for (const auto& face : lines) counts.push_back(face.size());
  return {buildStage(kind, kFaceSize, lines), kind, kFaceSize, counts, std::move(shape), kUnit, true};
}

Convex box(std::int32_t width, std::int32_t height) {
  return Convex({{-width, -height}, {width, -height}, {width, height}, {-width, height}});
}

/// Makes every segment pierceable and counts the contacts that begin.
class CountingRules : public Rules {
 public:
  bool pierce(const Entity&, const SegmentRef&) const override { return true; }
  void beginContact(Entity&, const SegmentRef& segment) override {
    if (!segment.warp) ++begun[{segment.part, segment.index}];
  }

  std::map<std::pair<std::uint32_t, std::uint32_t>, int> begun;
};

/// A new instance had no id yet, so its contacts were reported for the entity's first instance, with the index of a
/// segment of another part.
TEST(FoundByFuzzingTest, ANewInstanceTouchesOnlySegmentsOfItsPart) {
  constexpr std::int32_t end = 100 * kUnit;
  World world;
  MapPart left(world, 0);
  left.line({-3 * kUnit, -end}, {-3 * kUnit, end});
  left.warp({0, -end}, {0, end}, 1, {0, -end}, {0, end});
  left.initialize();
  MapPart right(world, 1);
  right.line({-end, 0}, {end, 0});  // continues across the edge
  right.warp({0, end}, {0, -end}, 0, {0, end}, {0, -end});
  right.initialize();
  CountingRules rules;
  world.setRules(rules);
  Entity entity(world, box(kUnit, kUnit));
  left.insert(entity, {-6 * kUnit, 0}, Angle());
  entity.setVelocity({10 * kUnit, 0});
  world.solve();
  EXPECT_EQ(entity.part(), 1u);
  EXPECT_EQ(rules.begun, (decltype(rules.begun){{{0, 0}, 1}, {{1, 0}, 1}}));
}

/// A rotation that a corner stops was tried with all instances that it would need. Some were added twice, once on each
/// way around the corner.
TEST(FoundByFuzzingTest, ARefusedRotationAddsNoInstanceAroundACorner) {
  for (const SolidKind kind : {SolidKind::kTetrahedron, SolidKind::kHexahedron, SolidKind::kOctahedron,
                               SolidKind::kDodecahedron, SolidKind::kIcosahedron}) {
    const FuzzScene scene = stageOf(kind, {}, box(30 * kUnit, 3 * kUnit));
    step_check::StepChecker checker({scene.stage.geometry(), scene.shape, scene.solid, scene.faceSize});
    World world = scene.stage;
    Entity entity(world, scene.shape);
    const Point corner = facePolygon(kind, kFaceSize)[1];
    MapPart(world, 0).insert(entity, corner - Point(corner.x / 6, corner.y / 6),
                             angleBetween(Point(1, 0), perpendicular(corner)));
    for (const std::int32_t turn : {9000, 300, -18000, -300}) {
      entity.rotate(turn);
      world.solve(&checker);
      EXPECT_EQ(checker.finishTick(), "") << nameOf(kind) << ", rotated by " << turn;
    }
  }
}

/// After exactly 8 192 lost datagrams, two numbers with the same low bits are equally near. The receiver took the lower
/// one in every second block of 16 384.
TEST(FoundByFuzzingTest, TheHigherOfTwoEquallyNearSequenceNumbersIsTaken) {
  constexpr std::uint64_t kHalfSpan = 1 << 13;
  const SessionKeys keys{CryptoKey{1}, CryptoKey{2}};
  const platon::Bytes content(1);
  for (const std::uint64_t received : {100u, 8292u, 16484u, 24676u}) {
    SealedChannel client(SealedChannel::Side::kClient, keys, 0);
    SealedChannel server(SealedChannel::Side::kServer, keys, 0);
    for (std::uint64_t i = 0; i < received; ++i) ASSERT_TRUE(server.open(client.seal(content)));
    for (std::uint64_t i = 0; i < kHalfSpan; ++i) client.seal(content);
    EXPECT_TRUE(server.open(client.seal(content))) << received;
  }
}

/// A CONNECT behind another command of a connection passed the check, although ENet sends it alone.
TEST(FoundByFuzzingTest, AConnectThatIsNotAloneIsRefused) {
  platon::Bytes content = pingContent(0);
  ASSERT_TRUE(readEnetCommands(content, EnetSender::kClient));
  const platon::Bytes connect = connectContent(1);
  ASSERT_TRUE(readEnetCommands(connect, EnetSender::kClient));
  content.insert(content.end(), connect.begin() + kCommandAt, connect.end());
  EXPECT_FALSE(readEnetCommands(content, EnetSender::kClient));
}

}  // namespace
}  // namespace platon::fuzz::found_by_fuzzing_test
