#include "tests/exactness/oracle/trace/trace_checker.h"

#include <gtest/gtest.h>

#include "tests/exactness/oracle/trace/sample_trace.h"

namespace platon::oracle::trace_checker_test {
namespace {

using RuleNames = std::set<std::string>;

/// Expects `rule` among the violated rules.
void expectViolated(const SampleTrace& trace, const std::string& rule) {
  const RuleNames violated = violatedRules(trace);
  EXPECT_TRUE(violated.contains(rule)) << rule << " was not found; found " << violated.size() << ": "
                                       << (violated.empty() ? "nothing" : *violated.begin());
}

/// Changes every instance with this id.
template <typename Change>
void changeAll(SampleTrace& trace, std::int64_t id, Change change) {
  for (TraceTick& tick : trace.ticks)
    for (TraceLeg& leg : tick.players[0].legs)
      for (TraceInstance& instance : leg)
        if (instance.id == id) change(instance);
}

void addLine(SampleTrace& trace, std::size_t face, const Segment& line) {
  trace.header.faces[face].lines.push_back(line);
}

/// The face beyond the right edge of face 0.
std::size_t rightFace(const SampleTrace& trace) { return static_cast<std::size_t>(trace.header.faces[0].warps[1].to); }

TEST(TraceChecker, AcceptsACorrectTrace) { EXPECT_EQ(violatedRules(sampleTrace()), RuleNames{}); }

TEST(TraceChecker, CountsTicksLegsCrossingsAndFaces) {
  const SampleTrace trace = sampleTrace();
  TraceChecker checker;
  ASSERT_TRUE(checker.checkLine(toJson(trace.header)));
  for (const TraceTick& tick : trace.ticks) ASSERT_TRUE(checker.checkLine(toJson(tick)));
  EXPECT_EQ(checker.report().ticks, 4);
  EXPECT_EQ(checker.report().legs, 7);
  EXPECT_EQ(checker.report().crossings, 1);
  EXPECT_EQ(checker.report().facesVisited.size(), 2u);
}

TEST(TraceChecker, AcceptsATouchedSegment) {
  SampleTrace trace = sampleTrace();
  addLine(trace, 0, {{-5000, -500}, {150000, -500}});
  EXPECT_EQ(violatedRules(trace), RuleNames{});
}

TEST(TraceChecker, FindsAnOverlapAtTheStart) {
  SampleTrace trace = sampleTrace();
  addLine(trace, 0, {{1000, -499}, {1000, -20000}});
  expectViolated(trace, "I1 place");
}

TEST(TraceChecker, FindsAPointInsideTheShape) {
  SampleTrace trace = sampleTrace();
  addLine(trace, 0, {{1000, 300}, {1000, 300}});
  expectViolated(trace, "I1 place");
}

TEST(TraceChecker, FindsASegmentOneSubunitInTheWay) {
  SampleTrace trace = sampleTrace();
  addLine(trace, 0, {{50000, -499}, {50000, -20000}});
  EXPECT_EQ(violatedRules(trace), RuleNames{"I1 path"});
}

TEST(TraceChecker, FindsASegmentInTheWayOfAnotherInstance) {
  SampleTrace trace = sampleTrace();
  const Vec place = trace.leg(2, 1)[1].position;
  addLine(trace, rightFace(trace), {place, place});
  EXPECT_EQ(violatedRules(trace), RuleNames{"I1 path"});
}

TEST(TraceChecker, FindsASegmentInTheWayOfANewInstance) {
  SampleTrace trace = sampleTrace();
  // A point on the path of the new instance, 1200 subunits before its end. It is outside the face, which violates
  // "header" as well.
  TraceInstance home = trace.leg(1, 2)[0];
  home.position.x -= 1200;
  const Vec place = behindWarp(trace.header, home, 1, 8).position;
  addLine(trace, rightFace(trace), {place, place});
  EXPECT_EQ(violatedRules(trace), (RuleNames{"I1 path", "header"}));
}

TEST(TraceChecker, FindsARotationThroughASegment) {
  SampleTrace trace = sampleTrace();
  trace.ticks.resize(1);
  TraceInstance turned = trace.leg(0, 0)[0];
  turned.angle = 9000;
  turned.shape = {{800, -1000}, {800, 1000}, {-1200, 0}};
  trace.leg(0, 1) = {turned};
  EXPECT_EQ(violatedRules(trace), RuleNames{});
  // Outside the shape before and after the rotation, but inside the hull of both.
  const Vec corner = turned.position + Vec{-900, -600};
  addLine(trace, 0, {corner, corner});
  EXPECT_EQ(violatedRules(trace), RuleNames{"I1 turn"});
}

TEST(TraceChecker, RejectsAnInstanceFiveSubunitsOff) {
  SampleTrace trace = sampleTrace();
  changeAll(trace, 8, [](TraceInstance& instance) { instance.position.x += instance.home ? 0 : 5; });
  expectViolated(trace, "I5 home");
}

TEST(TraceChecker, AcceptsAnInstanceFourSubunitsOff) {
  SampleTrace trace = sampleTrace();
  changeAll(trace, 8, [](TraceInstance& instance) { instance.position.x += 4; });
  EXPECT_EQ(violatedRules(trace), RuleNames{});
}

TEST(TraceChecker, FindsAnInstanceMisplacedRelativeToItsParent) {
  SampleTrace trace = sampleTrace();
  TraceLeg& leg = trace.leg(1, 2);
  leg[1].position.x += 3;
  TraceInstance third = behindWarp(trace.header, leg[1], 0, 9);
  const Segment onto = trace.header.faces[static_cast<std::size_t>(leg[1].face)].warps[0].onto;
  const Vec along = onto.b - onto.a;
  third.position = third.position + (along.x != 0 ? Vec{6, 0} : Vec{0, 6});
  leg.push_back(third);
  expectViolated(trace, "I5 parent");
}

TEST(TraceChecker, FindsAnAngleOneCentidegreeOff) {
  SampleTrace trace = sampleTrace();
  changeAll(trace, 8, [](TraceInstance& instance) { instance.angle += instance.home ? 0 : 1; });
  expectViolated(trace, "I5 angle");
}

TEST(TraceChecker, FindsAMissingInstance) {
  SampleTrace trace = sampleTrace();
  trace.ticks.resize(2);
  trace.leg(1, 2).pop_back();
  EXPECT_EQ(violatedRules(trace), RuleNames{"coverage"});
}

TEST(TraceChecker, FindsADuplicatePlacement) {
  SampleTrace trace = sampleTrace();
  TraceLeg& leg = trace.leg(1, 2);
  leg.push_back(leg[1]);
  leg.back().id = 9;
  expectViolated(trace, "duplicate");
}

TEST(TraceChecker, FindsAStaleInstance) {
  SampleTrace trace = sampleTrace();
  trace.leg(3, 2) = trace.leg(3, 1);
  EXPECT_EQ(violatedRules(trace), RuleNames{"stale"});
}

TEST(TraceChecker, FindsAnInstanceThatDoesNotMoveWithHome) {
  SampleTrace trace = sampleTrace();
  const Segment onto = trace.header.faces[0].warps[1].onto;
  const Vec aside = onto.a.x == onto.b.x ? Vec{0, 3} : Vec{3, 0};
  trace.leg(1, 2)[1].position = trace.leg(1, 2)[1].position + aside;
  trace.leg(2, 0) = trace.leg(1, 2);
  trace.leg(2, 1)[1].position = trace.leg(2, 1)[1].position - aside;
  trace.leg(2, 2) = trace.leg(2, 1);
  trace.ticks.resize(3);
  expectViolated(trace, "I6");
}

TEST(TraceChecker, FindsAMissingRehome) {
  SampleTrace trace = sampleTrace();
  trace.leg(2, 2) = trace.leg(2, 1);
  trace.ticks.resize(3);
  EXPECT_EQ(violatedRules(trace), RuleNames{"I7"});
}

TEST(TraceChecker, FindsAMoveInALegThatRehomes) {
  SampleTrace trace = sampleTrace();
  trace.ticks[2].players[0].legs.erase(trace.ticks[2].players[0].legs.begin() + 1);
  EXPECT_EQ(violatedRules(trace), RuleNames{"home"});
}

TEST(TraceChecker, FindsAJumpBetweenTicks) {
  SampleTrace trace = sampleTrace();
  trace.leg(1, 0)[0].position.y += 1;
  EXPECT_EQ(violatedRules(trace), RuleNames{"continuity"});
}

TEST(TraceChecker, AcceptsANewPlayerAnywhere) {
  SampleTrace trace = sampleTrace();
  trace.ticks[1].players.push_back({1, {{trace.leg(0, 0)[0]}}});
  EXPECT_EQ(violatedRules(trace), RuleNames{});
}

TEST(TraceChecker, FindsAnIdThatChangesItsFace) {
  SampleTrace trace = sampleTrace();
  trace.leg(1, 1)[0].face = 5;
  expectViolated(trace, "ids");
}

TEST(TraceChecker, FindsTwoHomes) {
  SampleTrace trace = sampleTrace();
  trace.leg(1, 2)[1].home = true;
  expectViolated(trace, "tree");
}

TEST(TraceChecker, FindsAMissingHome) {
  SampleTrace trace = sampleTrace();
  trace.leg(0, 0)[0].home = false;
  expectViolated(trace, "tree");
}

TEST(TraceChecker, FindsAnUnknownParent) {
  SampleTrace trace = sampleTrace();
  trace.leg(1, 2)[1].parent = 99;
  expectViolated(trace, "tree");
}

TEST(TraceChecker, FindsAWarpToAnotherFace) {
  SampleTrace trace = sampleTrace();
  trace.leg(1, 2)[1].warp = 2;
  expectViolated(trace, "tree");
}

TEST(TraceChecker, FindsADuplicateId) {
  SampleTrace trace = sampleTrace();
  trace.leg(1, 2)[1].id = 7;
  expectViolated(trace, "tree");
}

TEST(TraceChecker, FindsAShapeTwoSubunitsOff) {
  SampleTrace trace = sampleTrace();
  changeAll(trace, 8, [](TraceInstance& instance) { instance.shape[0].x += 2; });
  EXPECT_EQ(violatedRules(trace), RuleNames{"shape"});
}

TEST(TraceChecker, FindsAMissingShape) {
  SampleTrace trace = sampleTrace();
  changeAll(trace, 8, [](TraceInstance& instance) { instance.shape.clear(); });
  expectViolated(trace, "shape");
}

TEST(TraceChecker, FindsTwoShapesAtOneAngle) {
  SampleTrace trace = sampleTrace();
  trace.leg(3, 2)[0].shape[0].x += 1;
  expectViolated(trace, "shape");
}

// A step on a plane that moves to and fro.
SampleTrace stepOfMoves(std::size_t moves) {
  SampleTrace trace;
  trace.header = {"PLANE", {{-10, -10}, {10, -10}, {0, 10}}, {{}}};
  TraceInstance here;
  TraceInstance there = here;
  there.position = {1, 0};
  std::vector<TraceLeg> legs{{here}};
  while (legs.size() <= moves) legs.push_back({legs.back()[0] == here ? there : here});
  trace.ticks.push_back({1, "0123456789abcdef", {{0, legs}}});
  return trace;
}

TEST(TraceChecker, FindsTooManyMoves) {
  EXPECT_EQ(violatedRules(stepOfMoves(64)), RuleNames{});
  EXPECT_EQ(violatedRules(stepOfMoves(65)), RuleNames{"I2"});
}

TEST(TraceChecker, FindsTooManyEntries) {
  SampleTrace trace = sampleTrace();
  trace.ticks.resize(1);
  trace.ticks[0].players[0].legs.assign(706, trace.leg(0, 0));
  EXPECT_EQ(violatedRules(trace), RuleNames{});
  trace.ticks[0].players[0].legs.assign(707, trace.leg(0, 0));
  EXPECT_EQ(violatedRules(trace), RuleNames{"I2"});
}

TEST(TraceChecker, ChecksAPlane) {
  SampleTrace trace;
  trace.header = {"PLANE", {{-10, -10}, {10, -10}, {0, 10}}, {{{}, {{{100, -50}, {100, 50}}}, {}}}};
  TraceInstance here;
  TraceInstance there = here;
  there.position = {90, 0};
  trace.ticks.push_back({1, "0123456789abcdef", {{0, {{here}, {there}}}}});
  EXPECT_EQ(violatedRules(trace), RuleNames{});
  trace.leg(0, 1)[0].position.x = 91;
  EXPECT_EQ(violatedRules(trace), RuleNames{"I1 path"});
}

}  // namespace
}  // namespace platon::oracle::trace_checker_test
