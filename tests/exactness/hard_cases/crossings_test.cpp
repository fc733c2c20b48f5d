// Every edge and every corner of all five solids, met at every whole degree.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "platon/exact/angle.h"
#include "platon/exact/integer.h"
#include "platon/game/solid.h"
#include "tests/exactness/hard_cases/judged_world.h"
#include "tests/exactness/judge/run_length.h"
#include "tests/shared/game/real_face.h"

namespace platon::hard_cases {
namespace {

constexpr double kUnit = kSubunitsPerUnit;
constexpr double kRadius = 12 * kUnit;  // of the ball
constexpr double kApothem = 12051;      // of the 16-gon that it is
constexpr double kWay = 30 * kUnit;     // from the start to the point aimed at, and on behind it
constexpr int kTicks = 10;              // for twice that

std::string levelOf(SolidKind kind, const char* which) {
  std::string name(nameOf(kind));
  std::transform(name.begin(), name.end(), name.begin(), [](char c) { return static_cast<char>(c - 'A' + 'a'); });
  return "crossings/" + name + "_" + which + ".level";
}

/// One way over an edge (or at the corner where it begins).
struct Flight {
  SolidKind kind;
  int face;
  int edge;
  int degrees;  // of the way, from the face's +x

  RealFace ideal() const { return {kind, 200}; }
  Real direction() const { return turned({1, 0}, Angle::degrees(degrees)); }
  const PlatonicSolid::Neighbour& behind() const { return PlatonicSolid::of(kind).neighbour(face, edge); }
  /// Sine of the angle to the edge; not positive when the way leads in.
  double steepness() const { return dot(direction(), ideal().outwards(edge)); }
  std::string name() const {
    return std::string(nameOf(kind)) + ", face " + std::to_string(face) + ", edge " + std::to_string(edge) + ", at " +
           std::to_string(degrees) + " degrees";
  }
};

/// Every edge of every face at every n-th angle, another one at each edge, so that all together cover every degree.
template <class Visit>
void forEachFlight(const char* which, int everyNth, Visit&& visit) {
  const auto step = static_cast<int>(judge::runLength(everyNth, 1));
  int first = 0;
  for (const SolidKind kind : kAllSolids) {
    HardLevel level(levelOf(kind, which));
    const PlatonicSolid& solid = PlatonicSolid::of(kind);
    for (int face = 0; face < solid.faces(); ++face) {
      for (int edge = 0; edge < solid.edgesPerFace(); ++edge) {
        for (int degrees = first++ % step; degrees < 360; degrees += step) {
          if (testing::Test::HasFatalFailure() || !level.lawful()) return;
          const Flight flight{kind, face, edge, degrees};
          SCOPED_TRACE(flight.name());
          visit(flight, level);
        }
      }
    }
  }
}

struct Return {
  double off = 0;  // subunits from where it began
  int crossings = 0;
  bool touched = false;
};

/// Flies through `aim` and back again. Nothing when the start is not free.
std::optional<Return> flyThereAndBack(const Flight& flight, HardLevel& level, Real aim) {
  const Point start = nearest(aim - kWay * flight.direction());
  if (!level.place(static_cast<std::uint32_t>(flight.face), start)) return std::nullopt;
  const Point velocity = nearest((2 * kWay / kTicks) * flight.direction());
  Return back;
  for (int tick = 0; tick < 2 * kTicks; ++tick) {
    level.push(tick < kTicks ? velocity : -velocity);
    back.touched = back.touched || !level.rules.contacts.empty();
  }
  back.off = length(real(level.at() - start));
  back.crossings = static_cast<int>(level.entity().state().crossings);
  return back;
}

void expectHomeAgain(const Flight& flight, HardLevel& level) {
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

// Behind an edge every tick rounds the velocity, on the way back the same vector the other way round, but for the tick
// that crosses: one rounding of up to 0.71 subunits is left. An instance becomes home within one subunit of its true
// place, one on the way there and one on the way back. Where there are more crossings, these are independent of each
// other: they add up as a square root.
double allowed(int crossings) { return 2.71 * std::sqrt(std::max(crossings, 2) / 2.0); }

TEST(CrossingsTest, EveryEdgeAtEveryDegreeAndBack) {
  int flights = 0;
  double most = 0;
  forEachFlight("empty", 4, [&](const Flight& flight, HardLevel& level) {
    if (flight.steepness() < 0.017) return;
    const Real aim = flight.ideal().onEdge(flight.edge, 0.42 + flight.degrees % 17 * 0.01);
    const auto back = flyThereAndBack(flight, level, aim);
    ASSERT_TRUE(back);
    EXPECT_EQ(back->crossings, 2);
    EXPECT_FALSE(back->touched);
    EXPECT_LE(back->off, allowed(2));
    expectHomeAgain(flight, level);
    most = std::max(most, back->off);
    ++flights;
  });
  RecordProperty("flights", flights);
  RecordProperty("mostOff", std::to_string(most));
  EXPECT_GE(flights, 180 * 178 / 4 - 180);
}

// As near to a corner as the ball can pass without touching its post: over one edge after another round it.
TEST(CrossingsTest, BesideEveryCornerAtEveryDegreeAndBack) {
  constexpr double clearance = kRadius + 64;
  int flights = 0;
  int mostCrossings = 0;
  double most = 0;
  forEachFlight("empty", 4, [&](const Flight& flight, HardLevel& level) {
    if (flight.steepness() < 0.25) return;
    const RealFace ideal = flight.ideal();
    const Real aim = ideal.corner(flight.edge) + (clearance / flight.steepness()) * left(ideal.outwards(flight.edge));
    if (!isOnFace(flight, aim - kWay * flight.direction())) return;
    const auto back = flyThereAndBack(flight, level, aim);
    if (!back) return;  // a post of another corner is in the way of the start
    EXPECT_FALSE(back->touched);
    EXPECT_LE(back->off, allowed(back->crossings));
    expectHomeAgain(flight, level);
    most = std::max(most, back->off);
    mostCrossings = std::max(mostCrossings, back->crossings);
    ++flights;
  });
  RecordProperty("flights", flights);
  RecordProperty("mostCrossings", mostCrossings);
  RecordProperty("mostOff", std::to_string(most));
  EXPECT_GE(flights, 3000);
}

// Straight at a corner the ball meets the post, stops or slides round it, and a way back is always free. The corner,
// which blocks as a point, never gets into it, nor does the ball pass between the corner and the line in front of it:
// that is judged of each leg, in every instance.
TEST(CrossingsTest, AtEveryCornerAtEveryDegree) {
  int flights = 0;
  forEachFlight("empty", 4, [&](const Flight& flight, HardLevel& level) {
    const Real corner = flight.ideal().corner(flight.edge);
    const Real from = corner - kWay * flight.direction();
    if (!isOnFace(flight, from) || !level.place(static_cast<std::uint32_t>(flight.face), nearest(from))) return;
    const Point velocity = nearest((2 * kWay / kTicks) * flight.direction());
    bool touched = false;
    for (int tick = 0; tick < kTicks; ++tick) {
      level.push(velocity);
      touched = touched || !level.rules.contacts.empty();
      ASSERT_GE(distanceFromCorners(flight, level.at()), kApothem);
    }
    EXPECT_TRUE(touched) << "the post is told";
    for (int tick = 0; tick < 3; ++tick) {
      level.push(-velocity);
      EXPECT_TRUE(level.rules.contacts.empty()) << "nothing is in the way back";
    }
    ++flights;
  });
  RecordProperty("flights", flights);
  EXPECT_GE(flights, 3000);
}

// Two lines over every edge, 60 units apart: between them or along them, there and back.
TEST(CrossingsTest, BetweenLinesThatContinueOverEveryEdge) {
  int flights = 0;
  int untouched = 0;
  forEachFlight("over", 4, [&](const Flight& flight, HardLevel& level) {
    if (flight.steepness() < 0.017) return;
    const Real aim = flight.ideal().onEdge(flight.edge, flight.degrees % 2 == 0 ? 0.44 : 0.56);
    const auto back = flyThereAndBack(flight, level, aim);
    if (!back) return;  // a line is in the way of the start
    ++flights;
    if (back->touched) return;
    ++untouched;
    EXPECT_EQ(back->crossings, 2);
    EXPECT_LE(back->off, allowed(2));
    expectHomeAgain(flight, level);
  });
  RecordProperty("flights", flights);
  RecordProperty("untouched", untouched);
  EXPECT_GE(untouched, 1000);
  EXPECT_GE(flights, 2 * untouched) << "most slide along one of the lines";
}

// A wall on the edge is seen from both faces; each has its own copy, off by up to one subunit where the edge is
// slanted.
TEST(CrossingsTest, NothingGoesThroughAWallOnAnEdge) {
  int flights = 0;
  forEachFlight("walls", 4, [&](const Flight& flight, HardLevel& level) {
    if (flight.steepness() < 0.017) return;
    const RealFace ideal = flight.ideal();
    const Real out = ideal.outwards(flight.edge);
    const Point start = nearest(ideal.middle(flight.edge) - kWay * flight.direction());
    const Point velocity = nearest((2 * kWay / kTicks) * flight.direction());
    if (!level.place(static_cast<std::uint32_t>(flight.face), start)) return;
    double nearestSeen = HUGE_VAL;
    for (int tick = 0; tick < kTicks; ++tick) {
      level.push(velocity);
      ASSERT_EQ(level.entity().part(), static_cast<std::uint32_t>(flight.face));
      nearestSeen = std::min(nearestSeen, ideal.inradius() - dot(real(level.at()), out));
    }
    EXPECT_GE(nearestSeen, kApothem - 2);
    EXPECT_LE(nearestSeen, kRadius + 2) << "it touches the wall";
    EXPECT_EQ(level.entity().state().crossings, 0u);
    for (int tick = 0; tick < 2; ++tick) level.push(-velocity);
    EXPECT_TRUE(level.rules.contacts.empty()) << "nothing is in the way back";
    EXPECT_EQ(level.entity().rotation(), Angle());
    ++flights;
  });
  RecordProperty("flights", flights);
  EXPECT_GE(flights, 5000);
}

}  // namespace
}  // namespace platon::hard_cases
