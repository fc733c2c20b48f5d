#include "tests/exactness/reference/exact_scene.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace platon::reference::exact_scene_test {
namespace {

constexpr const char* kScene = "# a comment\nshape 0 0 4 0 0 3\n\nline -5 -6 7 8\nentity 1 2\nvelocity -3 4\n";

TEST(ExactSceneTest, ReadsEveryKeyword) {
  const ExactScene scene = readScene(kScene);
  EXPECT_EQ(scene.shape, (oracle::Polygon{{0, 0}, {4, 0}, {0, 3}}));
  EXPECT_EQ(scene.lines, (std::vector<oracle::Segment>{{{-5, -6}, {7, 8}}}));
  EXPECT_EQ(scene.start, (oracle::Vec{1, 2}));
  EXPECT_EQ(scene.velocity, (oracle::Vec{-3, 4}));
}

TEST(ExactSceneTest, ScalesEverything) {
  const ExactScene scene = scaled(readScene(kScene), 64);
  EXPECT_EQ(scene.shape, (oracle::Polygon{{0, 0}, {256, 0}, {0, 192}}));
  EXPECT_EQ(scene.lines, (std::vector<oracle::Segment>{{{-320, -384}, {448, 512}}}));
  EXPECT_EQ(scene.start, (oracle::Vec{64, 128}));
  EXPECT_EQ(scene.velocity, (oracle::Vec{-192, 256}));
}

TEST(ExactSceneTest, ErrorsNameTheirLine) {
  const auto faultOf = [](const std::string& text) {
    try {
      readScene(text);
    } catch (const std::runtime_error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const std::string shape = "shape 0 0 4 0 0 3\n";
  EXPECT_EQ(faultOf(shape + "line 1 2 3\n"), "line 2: odd number of coordinates");
  EXPECT_EQ(faultOf(shape + "line 1 2 3 x\n"), "line 2: not a whole number");
  EXPECT_EQ(faultOf(shape + "entity 1048576 0\n"), "line 2: numbers must be below 2^20");
  EXPECT_EQ(faultOf(shape + "\nsegment 1 2 3 4\n"), "line 3: not a line of a scene: segment 1 2 3 4");
  EXPECT_EQ(faultOf("shape 0 0 0 3 4 0\n"), "line 1: not a line of a scene: shape 0 0 0 3 4 0");
  EXPECT_EQ(faultOf("entity 0 0\n"), "the scene has no shape");
}

}  // namespace
}  // namespace platon::reference::exact_scene_test
