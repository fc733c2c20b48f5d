#include "client/hud/edge_sign.h"

#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

namespace platon::edge_sign_test {
namespace {

constexpr glm::vec2 kScreen{1280, 720};
constexpr glm::vec2 kReach{560, 300};

TEST(EdgeSign, WhatThePictureShowsHasNone) {
  for (const glm::dvec4 clip : {glm::dvec4(0, 0, 0, 1), {1, 1, 0, 1}, {-3, 2, 0, 3}})
    EXPECT_FALSE(edgeSignOf(clip, kScreen, kReach));
  EXPECT_TRUE(edgeSignOf({1.01, 0, 0, 1}, kScreen, kReach));
  EXPECT_TRUE(edgeSignOf({0, 0, 0, -1}, kScreen, kReach)) << "behind the camera";
}

// `clip` has +y up, the screen +y down.
TEST(EdgeSign, StandsOnTheRectangleInTheDirectionOfThePoint) {
  for (int degree = 0; degree < 360; ++degree) {
    const double angle = degree * std::numbers::pi / 180;
    const glm::dvec2 way(std::cos(angle), std::sin(angle));
    const glm::dvec4 clip(way.x * 3000 / kScreen.x, way.y * 3000 / kScreen.y, 0, 1);
    const auto sign = edgeSignOf(clip, kScreen, kReach);
    ASSERT_TRUE(sign) << degree;
    EXPECT_NEAR(sign->direction.x, way.x, 1e-5) << degree;
    EXPECT_NEAR(sign->direction.y, -way.y, 1e-5) << degree;
    const glm::vec2 offset = sign->place - kScreen / 2.0F;
    EXPECT_NEAR(std::max(std::abs(offset.x) / kReach.x, std::abs(offset.y) / kReach.y), 1, 1e-5) << degree;
    EXPECT_NEAR(glm::dot(offset, sign->direction), glm::length(offset), 1e-2) << degree;
    const auto behind = edgeSignOf(-clip, kScreen, kReach);
    ASSERT_TRUE(behind);
    EXPECT_EQ(behind->place, sign->place) << "a point behind the camera is projected to the other side";
  }
}

TEST(EdgeSign, TheArrowPointsThere) {
  const auto arrow = [](double x, double y) {
    return std::string(edgeSignOf({x, y, 0, 1}, {100, 100}, {40, 40})->arrow);
  };
  EXPECT_EQ(arrow(2, 0), "→");
  EXPECT_EQ(arrow(2, 2), "↗");
  EXPECT_EQ(arrow(0, 2), "↑");
  EXPECT_EQ(arrow(-2, 2), "↖");
  EXPECT_EQ(arrow(-2, 0), "←");
  EXPECT_EQ(arrow(-2, -0.1), "←");
  EXPECT_EQ(arrow(-2, -2), "↙");
  EXPECT_EQ(arrow(0, -2), "↓");
  EXPECT_EQ(arrow(2, -2), "↘");
}

TEST(EdgeSign, APointStraightBehindIsBelow) { EXPECT_STREQ(edgeSignOf({0, 0, 0, -1}, kScreen, kReach)->arrow, "↓"); }

}  // namespace
}  // namespace platon::edge_sign_test
