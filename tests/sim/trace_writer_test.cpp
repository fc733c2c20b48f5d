#include "tests/sim/trace_writer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "platon/game/player.h"
#include "platon/physics/entity.h"
#include "platon/physics/map_part.h"
#include "tests/shared/physics/maps.h"
#include "tests/shared/physics/shapes.h"
#include "tests/sim/sim_options.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace platon::sim::trace_writer_test {
namespace {

using testing::HasSubstr;

class TraceWriterTest : public testing::Test {
 protected:
  const TemporaryFolder folder_;
  const std::string path_ = folder_ / "trace";
};

TEST_F(TraceWriterTest, WritesASceneAsOnePlane) {
  World world;
  addPart(world, 0, {{{-50, -20}, {50, -20}}, {{17, 8}, {17, 8}}});
  Entity entity(world, square(10));
  MapPart(world, 0).insert(entity, {0, 0}, Angle());
  {
    TraceWriter trace(path_);
    trace.header(world, square(10), nullptr);
    entity.setVelocity({0, -15});
    world.solve(&trace);
    trace.tick(1, 0xabc);
    entity.setVelocity({});
    world.solve(&trace);
    trace.tick(2, 0xffffffffffffffffU);
  }
  EXPECT_EQ(
      readText(path_),
      "{\"solid\":\"PLANE\",\"subunits\":1024,\"shape\":[[-10,-10],[10,-10],[10,10],[-10,10]],\"faces\":"
      "[{\"face\":0,\"polygon\":[],\"lines\":[[-50,-20,50,-20],[17,8,17,8]],\"warps\":[]}],\"elements\":[]}\n"
      "{\"tick\":1,\"hash\":\"0000000000000abc\",\"open\":[],\"players\":[{\"id\":0,\"legs\":["
      "[{\"id\":0,\"face\":0,\"x\":0,\"y\":0,\"angle\":0}],[{\"id\":0,\"face\":0,\"x\":0,\"y\":-10,\"angle\":0}]]}]}\n"
      "{\"tick\":2,\"hash\":\"ffffffffffffffff\",\"open\":[],\"players\":[{\"id\":0,\"legs\":["
      "[{\"id\":0,\"face\":0,\"x\":0,\"y\":-10,\"angle\":0}]]}]}\n");
}

TEST_F(TraceWriterTest, WritesTheWarpOfFurtherInstances) {
  World world = twoStrips();
  Entity entity(world, square(100));
  MapPart(world, 1).insert(entity, {950, 3}, Angle());
  {
    TraceWriter trace(path_);
    trace.header(world, square(100), nullptr);
    world.solve(&trace);
    trace.tick(1, 0);
  }
  const std::string text = readText(path_);
  EXPECT_THAT(text,
              HasSubstr("\"warps\":[{\"from\":[1000,-5000,1000,5000],\"to\":2,\"onto\":[-1000,-5000,-1000,5000]}]"));
  EXPECT_THAT(text, HasSubstr("[[{\"id\":0,\"face\":1,\"x\":950,\"y\":3,\"angle\":0},"
                              "{\"id\":1,\"face\":2,\"x\":-1050,\"y\":3,\"angle\":0,\"via\":[0,0]}]"));
}

TEST_F(TraceWriterTest, WritesRotatedShapes) {
  World world;
  addPart(world, 0, {});
  Entity entity(world, square(10));
  MapPart(world, 0).insert(entity, {0, 0}, Angle::degrees(45));
  {
    TraceWriter trace(path_);
    trace.header(world, square(10), nullptr);
    world.solve(&trace);
    trace.tick(1, 0);
  }
  EXPECT_THAT(readText(path_), HasSubstr("\"angle\":4500,\"shape\":[[0,-14],[14,0],[0,14],[-14,0]]}"));
}

// Elements come before the other segments of their face. Each door of an open number is listed by its index.
TEST_F(TraceWriterTest, WritesElementsAndOpenDoors) {
  const std::string face =
      "%\n-90 0 90 0\n-90 -50 90 -50 door 3\n-90 40 -60 40 oneway\n-90 60 -60 60 up 2\n-90 70 90 70 door 4\n"
      "90 80 0 80 key 3\n90 90 0 90 hazard\n";
  const auto level = loadLevel("HEXAHEDRON\n1 0 0 0\n1 0 0\n480\n" + face + "%\n%\n0 50 0 90 door 3\n%\n%\n%\n").level;
  ASSERT_NE(level, nullptr);
  {
    TraceWriter trace(path_);
    trace.header(level->world, playerShape(), level.get());
    trace.tick(1, 0);
    trace.tick(2, 0, {1U << 3});
    trace.tick(3, 0, {1U << 3 | 1U << 4});
  }
  const std::string text = readText(path_);
  EXPECT_THAT(text, HasSubstr("\"lines\":[[-92160,-51200,92160,-51200],"));
  EXPECT_THAT(text, HasSubstr("],\"elements\":[{\"face\":0,\"line\":0,\"word\":\"door\",\"k\":3},"
                              "{\"face\":0,\"line\":1,\"word\":\"oneway\"},"
                              "{\"face\":0,\"line\":2,\"word\":\"up\",\"k\":2},"
                              "{\"face\":0,\"line\":3,\"word\":\"door\",\"k\":4},"
                              "{\"face\":0,\"line\":4,\"word\":\"key\",\"k\":3},"
                              "{\"face\":0,\"line\":5,\"word\":\"hazard\"},"
                              "{\"face\":2,\"line\":0,\"word\":\"door\",\"k\":3}]}\n"));
  EXPECT_THAT(text, HasSubstr("{\"tick\":1,\"hash\":\"0000000000000000\",\"open\":[],"));
  EXPECT_THAT(text, HasSubstr("{\"tick\":2,\"hash\":\"0000000000000000\",\"open\":[0,6],"));
  EXPECT_THAT(text, HasSubstr("{\"tick\":3,\"hash\":\"0000000000000000\",\"open\":[0,3,6],"));
}

TEST_F(TraceWriterTest, OmitsEntitiesThatAreNotInserted) {
  World world;
  addPart(world, 0, {});
  Entity absent(world, square(10));
  Entity present(world, square(10));
  MapPart(world, 0).insert(present, {0, 0}, Angle());
  {
    TraceWriter trace(path_);
    trace.header(world, square(10), nullptr);
    world.solve(&trace);
    trace.tick(1, 0);
  }
  EXPECT_THAT(readText(path_), HasSubstr("\"players\":[{\"id\":1,\"legs\":"));
}

TEST_F(TraceWriterTest, RefusesAFileThatCannotBeWritten) {
  EXPECT_THROW(TraceWriter(folder_ / "no/such/folder/trace"), UsageError);
}

}  // namespace
}  // namespace platon::sim::trace_writer_test
