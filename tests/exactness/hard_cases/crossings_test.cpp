// Crosses every edge and approaches every corner of all five solids at every whole degree.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "platon/exact/angle.h"
#include "platon/exact/integer.h"
#include "platon/game/solid.h"
#include "tests/exactness/hard_cases/checked_world.h"
#include "tests/exactness/step_check/run_length.h"
#include "tests/shared/game/real_face.h"

namespace platon::hard_cases::crossings_test {
namespace {

constexpr double kUnit = kSubunitsPerUnit;
constexpr double kRadius = 12 * kUnit;  // radius of the ball
constexpr double kApothem = 12051;      // apothem of the ball's 16-gon
constexpr double kPath = 30 * kUnit;    // distance from the start to the target point, and beyond it
constexpr int kTicks = 10;              // ticks for 2 * kPath

std::string levelOf(SolidKind kind, const char* which) {
  std::string name(nameOf(kind));
  std::transform(name.begin(), name.end(), name.begin(), [](char c) { return static_cast<char>(c - 'A' + 'a'); });
  return "crossings/" + name + "_" + which + ".level";
}

/// A straight path across an edge, or towards the corner at which the edge begins.
struct Flight {
  SolidKind kind;
  int face;
  int edge;
  int degrees;  // direction of the path, from the +x axis of the face

  RealFace ideal() const { return {kind, 200}; }
  Real direction() const { return turned({1, 0}, Angle::degrees(degrees)); }
  const PlatonicSolid::Neighbour& behind() const { return PlatonicSolid::of(kind).neighbour(face, edge); }
  /// Sine of the angle between path and edge. Positive if the path leads out of the face.
  double steepness() const { return dot(direction(), ideal().outwards(edge)); }
  std::string name() const {
    return std::string(nameOf(kind)) + ", face " + std::to_string(face) + ", edge " + std::to_string(edge) + ", at " +
           std::to_string(degrees) + " degrees";
  }
};

/// Visits every edge of every face at every n-th degree. The first degree differs from edge to edge, so that all edges
/// together cover every degree.
template <class Visit>
void forEachFlight(const char* which, int everyNth, Visit&& visit) {
  const auto step = static_cast<int>(step_check::stride(everyNth));
  int first = 0;
  for (const SolidKind kind : kAllSolids) {
    HardLevel level(levelOf(kind, which));
    const PlatonicSolid& solid = PlatonicSolid::of(kind);
    for (int face = 0; face < solid.faces(); ++face) {
      for (int edge = 0; edge < solid.edgesPerFace(); ++edge) {
        for (int degrees = first++ % step; degrees < 360; degrees += step) {
          if (testing::Test::HasFatalFailure() || !level.invariantsHold()) return;
          const Flight flight{kind, face, edge, degrees};
          SCOPED_TRACE(flight.name());
          visit(flight, level);
        }
      }
    }
  }
}

struct Return {
  double error = 0;  // distance from the start, subunits
  int crossings = 0;
  bool touched = false;
};

/// Moves the ball through `aim` and back. Returns nothing if the start is not free.
std::optional<Return> moveThereAndBack(const Flight& flight, HardLevel& level, Real aim) {
  const Point start = nearest(aim - kPath * flight.direction());
  if (!level.place(static_cast<std::uint32_t>(flight.face), start)) return std::nullopt;
  const Point velocity = nearest((2 * kPath / kTicks) * flight.direction());
  Return back;
  for (int tick = 0; tick < 2 * kTicks; ++tick) {
    level.push(tick < kTicks ? velocity : -velocity);
    back.touched = back.touched || !level.rules.contacts.empty();
  }
  back.error = length(real(level.at() - start));
  back.crossings = static_cast<int>(level.entity().state().crossings);
  return back;
}

void expectStartFaceAndAngle(const Flight& flight, HardLevel& level) {
  EXPECT_EQ(level.entity().part(), static_cast<std::uint32_t>(flight.face));
  EXPECT_EQ(level.entity().rotation(), Angle());
}

double distanceFromCorners(const Flight& flight, Point at) {
  double least = HUGE_VAL;
  for (int corner = 0; corner < PlatonicSolid::of(flight.kind).edgesPerFace(); ++corner) {
    least = std::min(least, length(flight.ideal().corner(corner) - real(at)));
  }
  return least;
}

bool isOnFace(const Flight& flight, Real point) {
  for (int edge = 0; edge < PlatonicSolid::of(flight.kind).edgesPerFace(); ++edge) {
    if (dot(point, flight.ideal().outwards(edge)) > flight.ideal().inradius() - 1) return false;
  }
  return true;
}

// Bound of the error in subunits. Beyond an edge every tick rounds the velocity. The roundings on the way back cancel
// those on the way there, except in the tick that crosses: one rounding of up to 0.71 subunits remains. Each rehome
// adds up to one subunit. The errors of further crossings are independent, so they add up like a square root.
double maxError(int crossings) { return 2.71 * std::sqrt(std::max(crossings, 2) / 2.0); }

TEST(CrossingsTest, ReturnsToTheStartAcrossEveryEdge) {
  int flights = 0;
  double largestError = 0;
  forEachFlight("empty", 4, [&](const Flight& flight, HardLevel& level) {
    if (flight.steepness() < 0.017) return;
    const Real aim = flight.ideal().onEdge(flight.edge, 0.42 + flight.degrees % 17 * 0.01);
    const auto back = moveThereAndBack(flight, level, aim);
    ASSERT_TRUE(back);
    EXPECT_EQ(back->crossings, 2);
    EXPECT_FALSE(back->touched);
    EXPECT_LE(back->error, maxError(2));
    expectStartFaceAndAngle(flight, level);
    largestError = std::max(largestError, back->error);
    ++flights;
  });
  RecordProperty("flights", flights);
  RecordProperty("maxError", std::to_string(largestError));
  EXPECT_GE(flights, 180 * 178 / 4 - 180);
}

// The ball passes each corner as close as it can without touching the post, across one edge after another.
TEST(CrossingsTest, ReturnsToTheStartAroundEveryCorner) {
  constexpr double clearance = kRadius + 64;
  int flights = 0;
  int maxCrossings = 0;
  double largestError = 0;
  forEachFlight("empty", 4, [&](const Flight& flight, HardLevel& level) {
    if (flight.steepness() < 0.25) return;
    const RealFace ideal = flight.ideal();
    const Real aim = ideal.corner(flight.edge) + (clearance / flight.steepness()) * left(ideal.outwards(flight.edge));
    if (!isOnFace(flight, aim - kPath * flight.direction())) return;
    const auto back = moveThereAndBack(flight, level, aim);
    if (!back) return;  // the post of another corner overlaps the start
    EXPECT_FALSE(back->touched);
    EXPECT_LE(back->error, maxError(back->crossings));
    expectStartFaceAndAngle(flight, level);
    largestError = std::max(largestError, back->error);
    maxCrossings = std::max(maxCrossings, back->crossings);
    ++flights;
  });
  RecordProperty("flights", flights);
  RecordProperty("maxCrossings", maxCrossings);
  RecordProperty("maxError", std::to_string(largestError));
  EXPECT_GE(flights, 3000);
}

// Moving straight at a corner, the ball hits the post and stops or slides around it; the way back is free. The corner
// point never gets inside the ball, and the ball never gets between the corner and its post: the oracle checks every
// instance in every leg.
TEST(CrossingsTest, IsStoppedByThePostOfEveryCorner) {
  int flights = 0;
  forEachFlight("empty", 4, [&](const Flight& flight, HardLevel& level) {
    const Real corner = flight.ideal().corner(flight.edge);
    const Real from = corner - kPath * flight.direction();
    if (!isOnFace(flight, from) || !level.place(static_cast<std::uint32_t>(flight.face), nearest(from))) return;
    const Point velocity = nearest((2 * kPath / kTicks) * flight.direction());
    bool touched = false;
    for (int tick = 0; tick < kTicks; ++tick) {
      level.push(velocity);
      touched = touched || !level.rules.contacts.empty();
      ASSERT_GE(distanceFromCorners(flight, level.at()), kApothem);
    }
    EXPECT_TRUE(touched) << "no contact with the post";
    for (int tick = 0; tick < 3; ++tick) {
      level.push(-velocity);
      EXPECT_TRUE(level.rules.contacts.empty()) << "blocked on the way back";
    }
    ++flights;
  });
  RecordProperty("flights", flights);
  EXPECT_GE(flights, 3000);
}

// Two segments cross every edge, 60 units apart. The ball moves between them or along them, and back.
TEST(CrossingsTest, MovesBetweenSegmentsThatContinueAcrossEveryEdge) {
  int flights = 0;
  int untouched = 0;
  forEachFlight("over", 4, [&](const Flight& flight, HardLevel& level) {
    if (flight.steepness() < 0.017) return;
    const Real aim = flight.ideal().onEdge(flight.edge, flight.degrees % 2 == 0 ? 0.44 : 0.56);
    const auto back = moveThereAndBack(flight, level, aim);
    if (!back) return;  // a segment overlaps the start
    ++flights;
    if (back->touched) return;
    ++untouched;
    EXPECT_EQ(back->crossings, 2);
    EXPECT_LE(back->error, maxError(2));
    expectStartFaceAndAngle(flight, level);
  });
  RecordProperty("flights", flights);
  RecordProperty("untouched", untouched);
  EXPECT_GE(untouched, 1000);
  EXPECT_GE(flights, 2 * untouched) << "most paths slide along one of the segments";
}

// A segment on an edge exists in both faces. The copies differ by up to one subunit if the edge is slanted.
TEST(CrossingsTest, IsStoppedByASegmentOnAnEdge) {
  int flights = 0;
  forEachFlight("walls", 4, [&](const Flight& flight, HardLevel& level) {
    if (flight.steepness() < 0.017) return;
    const RealFace ideal = flight.ideal();
    const Real out = ideal.outwards(flight.edge);
    const Point start = nearest(ideal.middle(flight.edge) - kPath * flight.direction());
    const Point velocity = nearest((2 * kPath / kTicks) * flight.direction());
    if (!level.place(static_cast<std::uint32_t>(flight.face), start)) return;
    double minDistance = HUGE_VAL;
    for (int tick = 0; tick < kTicks; ++tick) {
      level.push(velocity);
      ASSERT_EQ(level.entity().part(), static_cast<std::uint32_t>(flight.face));
      minDistance = std::min(minDistance, ideal.inradius() - dot(real(level.at()), out));
    }
    EXPECT_GE(minDistance, kApothem - 2);
    EXPECT_LE(minDistance, kRadius + 2) << "does not touch the segment";
    EXPECT_EQ(level.entity().state().crossings, 0u);
    for (int tick = 0; tick < 2; ++tick) level.push(-velocity);
    EXPECT_TRUE(level.rules.contacts.empty()) << "blocked on the way back";
    EXPECT_EQ(level.entity().rotation(), Angle());
    ++flights;
  });
  RecordProperty("flights", flights);
  EXPECT_GE(flights, 5000);
}

}  // namespace
}  // namespace platon::hard_cases::crossings_test
