// A planted violation of each word's rule is found, and what the rule allows is accepted.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/exactness/oracle/trace/sample_trace.h"
#include "tests/exactness/oracle/trace/solid_model.h"

namespace platon::oracle::trace_elements_test {
namespace {

using RuleNames = std::set<std::string>;

const RuleNames kHeader{"header"};
const RuleNames kPath{"I1 path"};
const RuleNames kPlace{"I1 place"};
const RuleNames kOpen{"open"};

/// The sample, in whose tick 1 the triangle, with its vertices at -1000 -800, 1000 -800 and 0 1200, moves on face 0
/// from 1000 300 to 90000 300.
class TraceElements : public testing::Test {
 protected:
  /// Adds a line with a word to face 0.
  void add(const Segment& line, const std::string& word, std::int64_t k = -1, std::int64_t k2 = -1) {
    TraceFace& face = trace_.header.faces[0];
    trace_.header.elements.push_back({0, static_cast<std::int64_t>(face.lines.size()), word, k, k2});
    face.lines.push_back(line);
  }
  RuleNames violatedWith(const Segment& line, const std::string& word, std::int64_t k = -1) {
    trace_ = sampleTrace();
    add(line, word, k);
    return violatedRules(trace_);
  }
  SampleTrace trace_ = sampleTrace();
  const Segment ahead_{{50000, -20000}, {50000, 20000}};  ///< in the way of tick 1; the triangle is on its left
  const Segment turnedRound_{ahead_.b, ahead_.a};
  const Segment within_{{1000, 300}, {1000, 400}};  ///< overlapped from the start to tick 1
};

TEST_F(TraceElements, HazardsAndPlatesBlockAlways) {
  EXPECT_EQ(violatedWith(ahead_, "hazard"), kPath);
  EXPECT_EQ(violatedWith(ahead_, "plate", 3), kPath);
  EXPECT_TRUE(violatedWith(within_, "hazard").contains("I1 place"));
  EXPECT_TRUE(violatedWith(within_, "plate", 3).contains("I1 place"));
}

TEST_F(TraceElements, CheckpointsAndKeysNeverBlock) {
  EXPECT_EQ(violatedWith(ahead_, "checkpoint"), RuleNames{});
  EXPECT_EQ(violatedWith(ahead_, "key", 31), RuleNames{});
  EXPECT_EQ(violatedWith(within_, "key", 0), RuleNames{});
}

TEST_F(TraceElements, DoorsBlockUnlessTheyAreOpen) {
  EXPECT_EQ(violatedWith(ahead_, "door", 5), kPath);
  for (TraceTick& tick : trace_.ticks) tick.open = {0};
  EXPECT_EQ(violatedRules(trace_), RuleNames{});
  trace_.ticks[1].open.clear();
  EXPECT_EQ(violatedRules(trace_), kPath);
}

TEST_F(TraceElements, TimedSegmentsBlockByTheClock) {
  for (std::int64_t later = 0; later < 12; ++later) {
    trace_ = sampleTrace();
    add(ahead_, "timed", 3, 2);
    for (TraceTick& tick : trace_.ticks) {
      tick.tick += later;
      if (tick.tick > 0 && (tick.tick - 1) % 5 >= 3) tick.open = {0};
    }
    const bool isOpen = !trace_.ticks[1].open.empty();
    EXPECT_EQ(violatedRules(trace_), isOpen ? RuleNames{} : kPath) << later;
    trace_.ticks[1].open = isOpen ? std::vector<std::int64_t>{} : std::vector<std::int64_t>{0};
    EXPECT_TRUE(violatedRules(trace_).contains("open")) << later;
  }
}

TEST_F(TraceElements, NobodyArrivesInAClosedDoor) {
  EXPECT_EQ(violatedWith(within_, "door", 5), kPlace);
  for (TraceTick& tick : trace_.ticks) tick.open = {0};
  EXPECT_EQ(violatedRules(trace_), RuleNames{});
}

TEST_F(TraceElements, ADoorThatClosesOnAPlayerCanBeLeftButNotEnteredAgain) {
  add(within_, "door", 5);
  trace_.ticks[0].open = {0};
  EXPECT_EQ(violatedRules(trace_), RuleNames{});
  std::vector<TraceLeg>& legs = trace_.ticks[1].players[0].legs;
  TraceLeg back = legs[0];
  back[0].position.x += 1;
  legs.insert(legs.begin() + 1, back);
  EXPECT_EQ(violatedRules(trace_), RuleNames{}) << "the door is not left yet";
  legs.insert(legs.begin() + 2, legs[2]);
  legs.insert(legs.begin() + 3, back);
  EXPECT_EQ(violatedRules(trace_), kPath);
}

TEST_F(TraceElements, OnlyKnownDoorsOpenAndAllOfANumberTogether) {
  add(ahead_, "key", 5);
  add({{0, 20000}, {9, 20000}}, "door", 5);
  add({{0, 30000}, {9, 30000}}, "door", 5);
  add({{0, 40000}, {9, 40000}}, "door", 6);
  EXPECT_EQ(violatedRules(trace_), RuleNames{});
  for (const auto& open : std::vector<std::vector<std::int64_t>>{{1, 2}, {3}, {3, 1, 2}}) {
    trace_.ticks[2].open = open;
    EXPECT_EQ(violatedRules(trace_), RuleNames{});
  }
  for (const auto& open : std::vector<std::vector<std::int64_t>>{{1}, {2, 3}, {0}, {4}, {-1}, {3, 3}}) {
    trace_.ticks[2].open = open;
    EXPECT_EQ(violatedRules(trace_), kOpen);
  }
}

TEST_F(TraceElements, AnUpSegmentBlocksWhoseUpPointsToItsEdge) {
  for (const std::int64_t edge : {0, 1, 2, 3})
    EXPECT_EQ(violatedWith(ahead_, "up", edge), edge == 2 ? kPath : RuleNames{}) << edge;
  EXPECT_EQ(violatedWith(within_, "up", 2), kPlace);
  EXPECT_EQ(violatedWith(within_, "up", 1), RuleNames{});
}

Polygon rotated(const Polygon& shape, std::int64_t angle) {
  const auto radians = static_cast<double>(angle) * 2 * std::numbers::pi / static_cast<double>(kTurn);
  Polygon result;
  for (const Vec v : shape) {
    const auto x = static_cast<double>(v.x);
    const auto y = static_cast<double>(v.y);
    result.push_back({std::llround(x * std::cos(radians) - y * std::sin(radians)),
                      std::llround(x * std::sin(radians) + y * std::cos(radians))});
  }
  return result;
}

TEST_F(TraceElements, HalfAnEdgesAngleBelongsToAnEdge) {
  for (const std::int64_t angle : {0, 4499, 4500, 13499, 13500, 18000, 22499, 22500, 31499, 31500}) {
    const std::int64_t pointedTo = ((angle + 4500) / 9000 + 2) % 4;
    for (const std::int64_t edge : {0, 1, 2, 3}) {
      trace_ = sampleTrace();
      trace_.ticks.resize(1);
      add(within_, "up", edge);
      for (TraceLeg& leg : trace_.ticks[0].players[0].legs) {
        leg[0].angle = angle;
        if (angle != 0) leg[0].shape = rotated(trace_.header.shape, angle);
      }
      EXPECT_EQ(violatedRules(trace_), edge == pointedTo ? kPlace : RuleNames{}) << angle << " " << edge;
    }
  }
}

TEST_F(TraceElements, AOnewaySegmentBlocksFromItsLeftSideOnly) {
  EXPECT_EQ(violatedWith(ahead_, "oneway"), kPath);
  EXPECT_EQ(violatedWith(turnedRound_, "oneway"), RuleNames{});
  EXPECT_EQ(violatedWith(within_, "oneway"), RuleNames{}) << "who is in it is not on its left side";
  EXPECT_EQ(violatedWith({{2000, -20000}, {2000, 20000}}, "oneway"), kPath) << "touched";
  EXPECT_EQ(violatedWith({{1999, -20000}, {1999, 20000}}, "oneway"), RuleNames{}) << "a subunit inside";
}

TEST_F(TraceElements, APlayerThatHasComeThroughAOnewaySegmentCannotGoBack) {
  add(turnedRound_, "oneway");
  std::vector<TraceLeg>& legs = trace_.ticks[1].players[0].legs;
  legs = {legs[0], legs[1], legs[0]};
  trace_.ticks.resize(2);
  EXPECT_EQ(violatedRules(trace_), kPath);
  legs = {legs[0], {legs[0][0]}, legs[0]};
  legs[1][0].position.x = 50500;
  EXPECT_EQ(violatedRules(trace_), RuleNames{}) << "unless it has turned round within it";
}

TEST_F(TraceElements, AnElementDoesNotBlockACorner) {
  trace_.header.elements.push_back({0, 0, "plate", 0});
  EXPECT_EQ(violatedRules(trace_), kHeader);
}

TEST_F(TraceElements, ElementsHaveALineAWordAndItsNumber) {
  const TraceElement good{0, 4, "door", 31};
  const auto violatedBy = [&](const TraceElement& element) {
    trace_ = sampleTrace();
    trace_.header.faces[0].lines.push_back({{0, 20000}, {0, 20000}});
    trace_.header.elements = {element};
    return violatedRules(trace_);
  };
  EXPECT_EQ(violatedBy(good), RuleNames{});
  EXPECT_EQ(violatedBy({6, 4, "door", 31}), kHeader);
  EXPECT_EQ(violatedBy({-1, 4, "door", 31}), kHeader);
  EXPECT_EQ(violatedBy({0, 5, "door", 31}), kHeader);
  EXPECT_EQ(violatedBy({0, 4, "wall", 31}), kHeader);
  EXPECT_EQ(violatedBy({0, 4, "door", 32}), kHeader);
  EXPECT_EQ(violatedBy({0, 4, "door"}), kHeader);
  EXPECT_EQ(violatedBy({0, 4, "hazard", 0}), kHeader);
  EXPECT_EQ(violatedBy({0, 4, "up", 4}), kHeader);
  EXPECT_EQ(violatedBy({0, 4, "up", 3}), RuleNames{});
  EXPECT_EQ(violatedBy({0, 4, "oneway"}), kHeader) << "a point has no sides";
  EXPECT_EQ(violatedBy({0, 4, "timed", 3600, 1}), RuleNames{});
  EXPECT_EQ(violatedBy({0, 4, "timed", 3601, 1}), kHeader);
  EXPECT_EQ(violatedBy({0, 4, "timed", 1, 3601}), kHeader);
  EXPECT_EQ(violatedBy({0, 4, "timed", 0, 1}), kHeader);
  EXPECT_EQ(violatedBy({0, 4, "timed", 1, 0}), kHeader);
  EXPECT_EQ(violatedBy({0, 4, "timed", 1}), kHeader);
  EXPECT_EQ(violatedBy({0, 4, "door", 31, 1}), kHeader);
  trace_.header.elements = {good, good};
  EXPECT_EQ(violatedRules(trace_), kHeader);
}

/// Tick 1 begins at another place, with a new instance.
SampleTrace returnedTo(Vec place) {
  SampleTrace trace = sampleTrace();
  trace.ticks.resize(3);
  trace.ticks[1].players[0].legs = {trace.leg(0, 0), {trace.leg(1, 1)}};
  TraceInstance back = trace.leg(0, 0)[0];
  back.id = 99;
  back.position = place;
  trace.ticks[2].players[0].legs = {{back}};
  return trace;
}

TEST_F(TraceElements, APlayerReturnsToTheStartOrToTheMiddleOfACheckpoint) {
  const RuleNames jump{"continuity"};
  EXPECT_EQ(violatedRules(returnedTo({1000, 300})), RuleNames{});
  EXPECT_EQ(violatedRules(returnedTo({1000, 301})), jump);
  trace_ = returnedTo({20001, 5000});
  EXPECT_EQ(violatedRules(trace_), jump);
  add({{20000, 4000}, {20001, 6000}}, "checkpoint");
  EXPECT_EQ(violatedRules(trace_), RuleNames{});
  trace_.ticks[2].players[0].legs[0][0].position.x = 20002;
  EXPECT_EQ(violatedRules(trace_), jump);
}

TEST_F(TraceElements, AReturnHasANewInstance) {
  trace_ = returnedTo({1000, 300});
  trace_.ticks[2].players[0].legs[0][0].id = trace_.leg(1, 1)[0].id;
  EXPECT_EQ(violatedRules(trace_), RuleNames{"continuity"});
}

}  // namespace
}  // namespace platon::oracle::trace_elements_test
