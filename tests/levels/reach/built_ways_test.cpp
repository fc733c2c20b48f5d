// Ways that levels were built for, to show that what Reach denies is possible: each of the first was once denied.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "levels/reach/jump_heights.h"
#include "levels/reach/reach.h"
#include "platon/game/player_motion.h"
#include "tests/shared/game/played_game.h"

namespace platon::built_ways_test {
namespace {

struct Press {
  std::uint8_t buttons;
  int ticks;
};

struct Case {
  std::string name;
  std::string level;
  std::vector<Press> way;
  int crossings;
};

void PrintTo(const Case& built, std::ostream* out) { *out << built.name; }

const std::vector<Case> kCases = {
    {"Slope1191",
     "HEXAHEDRON\n0 -9.7 8.3 0\n0 -60 50\n480\n%\n-100 -119.1 100 119.1\n-150 -130 150 -130\n150 -130 150 150\n150 150 "
     "-150 150\n-150 150 -150 -130\n%\n%\n%\n%\n%\n",
     {{kNone, 31}, {Input::kLeft | Input::kJump, 15}},
     0},
    {"KeyInADip",
     "HEXAHEDRON\n0 -40 70 0\n0 75 30\n480\n%\n-100 115 0 0\n-100 115 -100 230\n-100 230 230 230\n0 0 -10 0\n-10 0 -10 "
     "-230\n230 230 230 -230\n-10 -230 230 -230\n45 -230 45 230 door 1\n29 -16 29 -15 key 1\n%\n%\n%\n%\n%\n",
     {{Input::kRight, 33}, {Input::kRight | Input::kJump, 45}},
     0},
    {"LipOverADip",
     "HEXAHEDRON\n0 -40 71 0\n0 85 63\n480\n%\n-100 116 0 1\n20 15 20 201 hazard\n-100 116 -100 201\n-100 201 20 "
     "201\n0 1 -10 1\n-10 1 -10 -199\n200 201 200 -199\n20 201 200 201\n-10 -199 200 -199\n%\n%\n%\n%\n%\n",
     {{Input::kRight, 33}, {Input::kRight | Input::kJump, 40}},
     0},
    {"OnewayThatEndsOnAnEdge",
     "HEXAHEDRON\n1 -687.85 100 0\n1 -687.85 -200\n1400\n%\n300 0 700 0 oneway\n%\n-675.6 300 -675.6 -300\n-700 -300 "
     "-675.6 -300\n-700 300 -675.6 300\n%\n%\n%\n%\n",
     {{kNone, 100}},
     0},
    {"OnewayThatEndsOnAnEdgeOfAPentagon",
     "DODECAHEDRON\n1 -100 -263.2264 90\n1 100 -263.2264\n400\n%\n0 -125.2764 0 -275.2764 oneway\n%\n-150 -251.1764 "
     "150 -251.1764\n-150 -275.2764 -150 -251.1764\n150 -275.2764 150 -251.1764\n%\n%\n%\n%\n%\n%\n%\n%\n%\n%\n",
     {{kNone, 120}},
     0},
    {"StepToAOneway",
     "HEXAHEDRON\n0 -100 41.983 0\n0 112 -118.017\n1800\n%\n-170 -18.0172 100 -18.0172 oneway\n60 -14.3172 170 "
     "-14.3172 oneway\n-150 -180 150 -180\n150 -180 150 180\n150 180 -150 180\n-150 180 -150 -180\n%\n%\n%\n%\n%\n",
     {{Input::kRight, 84}, {kNone, 20}},
     0},
    {"OnewaysOnALargeFace",
     "HEXAHEDRON\n0 -600 153.092 0\n0 90 -166.908\n20000\n%\n-10000 -66.9082 0 -66.9082 oneway\n-300 -40.9082 10000 "
     "-40.9082 oneway\n%\n%\n%\n%\n%\n",
     {{Input::kRight, 230}},
     0},
    {"RestartInADoor",
     "HEXAHEDRON\n0 0 11.7696 0\n0 0 -150\n480\n%\n-60 0 34 0 door 1\n34 0 34 -230\n-60 -230 200 -230\n-60 -230 -60 "
     "200\n-60 200 200 200\n200 200 200 -230\n180 -225 180 -205 key 1\n%\n%\n%\n%\n%\n",
     {{Input::kRight, 130}, {Input::kRestart, 1}, {kNone, 60}},
     0},
    {"RestartInADoorOfAPlate",
     "HEXAHEDRON\n0 0 11.7696 0\n0 0 -150\n480\n%\n-60 0 34 0 door 1\n34 0 34 -230\n-60 -230 200 -230\n-60 -230 -60 "
     "200\n-60 200 200 200\n200 200 200 -230\n40 -228 200 -228 plate 1\n%\n%\n%\n%\n%\n",
     {{Input::kRight, 130}, {Input::kRestart, 1}, {kNone, 60}},
     0},
    {"GapBetweenOneways",
     "DODECAHEDRON\n0 0 -150.2211 0\n1 0 -160.2211\n320\n%\n-60 -220.2211 -12 -220.2211 oneway\n12 -220.2211 60 "
     "-220.2211 oneway\n-60 -220.2211 -60 -120.2211\n60 -220.2211 60 -120.2211\n-60 -120.2211 60 "
     "-120.2211\n%\n%\n%\n%\n%\n%\n%\n%\n%\n%\n%\n",
     {{kNone, 90}},
     1},
};

// Ways on which a player that has slid is faster than a run on ground that is not steep.
const std::vector<Case> kFastCases = {
    {"HopAfterASlide",
     "HEXAHEDRON\n0 -314 331 0\n5 0 0\n760\n%\n-330 330 -60 -7.5\n-302.459 350 -8 -18.0734 hazard\n-352 "
     "350 -302.459 350 hazard\n-352 350 -352 300 hazard\n-352 300 -320 300 hazard\n-40 -84 8.4 "
     "-84\n%\n%\n%\n%\n%\n",
     {{Input::kDown, 77}, {Input::kRight, 2}, {kNone, 4}, {Input::kJump, 30}, {Input::kRight | Input::kJump, 40}},
     0},
    {"SlideIntoARampOf49Degrees",
     "HEXAHEDRON\n0 -314 331 0\n5 0 0\n760\n%\n-330 330 -60 -7.5\n-302.459 350 -70 59.4266 hazard\n-352 "
     "350 -302.459 350 hazard\n-352 350 -352 300 hazard\n-352 300 -320 300 hazard\n-60 -7.5 -50.8152 "
     "3.0659\n%\n%\n%\n%\n%\n",
     {{Input::kDown, 67}, {Input::kRight, 5}, {Input::kRight | Input::kJump, 60}},
     0},
};

class FastWayTest : public testing::TestWithParam<Case> {};

TEST_P(FastWayTest, IsAllowedAtEveryTick) {
  const auto level = levelOf(GetParam().level);
  const Reach reach(*level, GetParam().crossings);
  const JumpHeights heights(*level, {});
  PlayedGame played(level);
  bool isFast = false;
  for (const Press& press : GetParam().way) {
    for (int tick = 0; tick < press.ticks; ++tick) {
      played.run(1, press.buttons);
      const EntityState& ball = played.entity();
      ASSERT_TRUE(reach.crossingsTo(ball.part, ball.position, ball.angle)) << "tick " << played.game.tick();
      ASSERT_TRUE(heights.reaches(ball.part, ball.position)) << "tick " << played.game.tick();
      isFast = isFast || (played.grounded() &&
                          std::hypot(played.player().velocity.x, played.player().velocity.y) > motion::kRunSpeed * 1.5);
    }
  }
  EXPECT_TRUE(isFast) << "or the way tests nothing";
}

class BuiltWayTest : public testing::TestWithParam<Case> {};

TEST_P(BuiltWayTest, IsPossibleInTheGameAndNotDenied) {
  const auto level = levelOf(GetParam().level);
  PlayedGame played(level);
  for (const Press& press : GetParam().way) played.run(press.ticks, press.buttons);
  ASSERT_NE(played.player().arrived, 0) << "the way does not lead to the goal";
  const auto crossings = Reach(*level, GetParam().crossings).crossingsToGoal();
  ASSERT_TRUE(crossings) << "denied with " << GetParam().crossings << " crossings";
  EXPECT_LE(*crossings, GetParam().crossings);
  EXPECT_TRUE(JumpHeights(*level, {}).reachesGoal());
}

INSTANTIATE_TEST_SUITE_P(Strangers, FastWayTest, testing::ValuesIn(kFastCases),
                         [](const auto& spec) { return spec.param.name; });

INSTANTIATE_TEST_SUITE_P(Strangers, BuiltWayTest, testing::ValuesIn(kCases),
                         [](const auto& spec) { return spec.param.name; });

}  // namespace
}  // namespace platon::built_ways_test
