#include "client/scene/camera_lead.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace platon::camera_lead_test {
namespace {

constexpr double kTick = 1.0 / 60;
constexpr double kRun = 3.2;     // level units a tick
constexpr double kAtOnce = 1e9;  // a rate at which a point follows at once

Pose poseAt(double right, double up) { return {{right, up, 100}, {0, 1, 0}, {0, 0, 1}}; }

// The lead now.
glm::dvec2 leadOf(const CameraLead& lead, bool reduced = false) { return lead.followed(kAtOnce, 1e-7, reduced); }

struct Walk {
  CameraLead lead;
  glm::dvec2 place{0};

  Walk() { lead.reset(poseAt(0, 0)); }
  void step(glm::dvec2 way) {
    place += way;
    lead.move(poseAt(place.x, place.y));
    lead.wait(kTick);
  }
};

TEST(CameraLead, LeadsWhoRunsOn) {
  for (const double direction : {-1.0, 1.0}) {
    Walk walk;
    double last = 0;
    for (int tick = 0; tick < 120; ++tick) {
      walk.step({direction * kRun, 0});
      const double lead = direction * leadOf(walk.lead).x;
      EXPECT_GE(lead, last - 1e-6);
      EXPECT_LE(lead - last, kRun) << "the picture never overtakes the player by more than the player runs";
      last = lead;
    }
    EXPECT_NEAR(last, CameraLead::kMaxLead, 6);
  }
}

TEST(CameraLead, SmallTurnsDoNotMoveIt) {
  Walk walk;
  for (int tick = 0; tick < 600; ++tick) {
    walk.step({tick / 8 % 2 == 0 ? kRun : -kRun, 0});
    EXPECT_NEAR(leadOf(walk.lead).x, 0, 1e-3);
  }
}

// A jump of 60 level units in 24 ticks each way.
TEST(CameraLead, InAJumpThePictureMovesLessThanThePlayer) {
  Walk walk;
  double highest = 0;
  for (int tick = 0; tick < 48; ++tick) {
    const double height = 60 * (1 - std::pow((tick + 1 - 24) / 24.0, 2));
    walk.step({0, height - walk.place.y});
    const double shown = walk.place.y + leadOf(walk.lead).y;
    highest = std::max(highest, shown);
    EXPECT_GE(shown, -12);
  }
  EXPECT_LT(highest, 35);
}

TEST(CameraLead, LeadsALongFall) {
  Walk walk;
  for (int tick = 0; tick < 90; ++tick) walk.step({0, -5.5});
  EXPECT_LT(leadOf(walk.lead).y, -50);
  EXPECT_GE(leadOf(walk.lead).y, -CameraLead::kMaxLead);
}

TEST(CameraLead, WithReducedMotionNothingLeadsThePlayer) {
  Walk walk;
  for (int tick = 0; tick < 90; ++tick) walk.step({kRun, -5.5});
  EXPECT_NEAR(leadOf(walk.lead, true).x, 0, 1e-3);
  EXPECT_GE(leadOf(walk.lead, true).y, 0);
}

TEST(CameraLead, GoesBackWhenThePlayerStands) {
  Walk walk;
  for (int tick = 0; tick < 90; ++tick) walk.step({kRun, -5.5});
  walk.lead.wait(5);
  EXPECT_NEAR(leadOf(walk.lead).x, 0, 1e-3);
  EXPECT_NEAR(leadOf(walk.lead).y, 0, 0.2);
}

// The closed solution against small steps of the differential equation.
TEST(CameraLead, TheFollowingPointSolvesItsEquation) {
  constexpr double kRate = 14;
  for (const glm::dvec2 way : {glm::dvec2(20, 10), glm::dvec2(45, -60), glm::dvec2(-200, 200)}) {
    CameraLead lead;
    lead.reset(poseAt(0, 0));
    lead.move(poseAt(way.x, way.y));
    CameraLead now = lead;
    glm::dvec2 place(0);
    constexpr int kSteps = 200000;
    constexpr double kStep = 2.0 / kSteps;
    for (int i = 0; i < kSteps; ++i) {
      place += (leadOf(now) - place) * kRate * kStep;
      now.wait(kStep);
    }
    const glm::dvec2 solved = lead.followed(kRate, 2, false);
    EXPECT_NEAR(solved.x, place.x, 0.01);
    EXPECT_NEAR(solved.y, place.y, 0.01);
  }
}

TEST(CameraLead, IsCarriedOverAnEdge) {
  CameraLead lead;
  lead.reset(poseAt(0, 0));
  lead.move(poseAt(125, 0));
  const glm::dvec2 before = leadOf(lead);
  lead.move({{125, 0, 100}, {0, 1, 0}, {1, 0, 0}});
  EXPECT_EQ(leadOf(lead), before);
}

}  // namespace
}  // namespace platon::camera_lead_test
