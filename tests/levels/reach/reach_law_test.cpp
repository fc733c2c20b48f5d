// What a player does in the game is possible in Reach: on shipped levels, on levels that were built to fool it, and on
// random ones. So what Reach proves is true (I9).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <memory>
#include <numeric>
#include <string>
#include <string_view>
#include <vector>

#include "levels/reach/jump_heights.h"
#include "levels/reach/reach.h"
#include "levels/solve/level_solver.h"
#include "tests/levels/reach/explorer.h"
#include "tests/shared/game/played_game.h"
#include "tests/support/files.h"
#include "tests/support/run/repetitions.h"
#include "tests/support/sample_word.h"

namespace platon::reach_law_test {
namespace {

constexpr std::uint64_t kSeed = 31;
constexpr int kFaceSize = 220;
// Of the ways that are compared: with each more of them, Reach takes ten times as long on crowded levels.
constexpr int kMaxCrossings = 1;

// PLATON_EXPLORE sets the ticks of each level.
std::uint64_t exploredTicks() {
  if (const char* const ticks = std::getenv("PLATON_EXPLORE")) return std::strtoull(ticks, nullptr, 10);
  return repetitions(std::uint64_t{60'000});
}

// Round the goal, so that the search does not end at it.
const std::string kWalls = "-20 -20 20 -20\n20 -20 20 20\n20 20 -20 20\n-20 20 -20 -20\n";

struct Case {
  std::string name;
  std::string text;
};

void PrintTo(const Case& level, std::ostream* out) { *out << level.name; }

struct Solid {
  SolidKind kind;
  const char* word;
};

constexpr Solid kSolids[] = {{SolidKind::kTetrahedron, "TETRAHEDRON"},
                             {SolidKind::kHexahedron, "HEXAHEDRON"},
                             {SolidKind::kOctahedron, "OCTAHEDRON"},
                             {SolidKind::kDodecahedron, "DODECAHEDRON"},
                             {SolidKind::kIcosahedron, "ICOSAHEDRON"}};

std::string text(const char* layout, auto... values) {
  char line[200];
  std::snprintf(line, sizeof line, layout, values...);
  return line;
}

std::string lineOf(Vec a, Vec b, const std::string& word = "") {
  return text("%.4f %.4f %.4f %.4f ", a.x, a.y, b.x, b.y) + word + "\n";
}

// A level of this solid with these lines on face 0. The goal is walled in on the last face.
std::string levelText(const Solid& solid, const std::string& start, const std::string& lines) {
  const int faces = PlatonicSolid::of(solid.kind).faces();
  std::string result = solid.word + text("\n0 %s\n%d 0 0\n%d\n%%\n", start.c_str(), faces - 1, kFaceSize) + lines;
  for (int face = 1; face < faces; ++face) {
    result += "%\n";
    if (face == faces - 1) result += kWalls;
  }
  return result;
}

void addIfValid(std::vector<Case>& cases, const std::string& name, const std::string& level) {
  if (loadLevel(level).level) cases.push_back({name, level});
}

Vec inUnits(Point point) { return {point.x / 1024.0, point.y / 1024.0}; }

// Nothing but the posts at the corners, with the start just above one.
std::vector<Case> posts() {
  std::vector<Case> cases;
  for (const Solid& solid : kSolids) {
    const std::vector<Point> polygon = facePolygon(solid.kind, kFaceSize);
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vec corner = inUnits(polygon[i]);
      const Vec inwards = corner * (-1 / length(corner));
      const Vec start = corner + inwards * 15;
      // Up is from the corner to the middle of the face, to the degree.
      const int degrees = static_cast<int>(std::lround(std::atan2(-inwards.x, inwards.y) * 180 / 3.14159265358979));
      for (const int turn : {0, 1, -2, 45})
        addIfValid(cases, solid.word + text("Corner%zuTurn%d", i, turn + 90),
                   levelText(solid, text("%.3f %.3f %d", start.x, start.y, degrees + turn), ""));
    }
  }
  return cases;
}

// Two sides that meet below the start, or nearly: slopes of all angles to the horizontal, walls and overhangs.
std::vector<Case> wedges() {
  std::vector<Case> cases;
  const auto side = [](int degrees, double gap) {
    const double angle = degrees * 3.14159265358979 / 180;
    return Line{{gap, -40}, Vec{gap, -40} + Vec{std::cos(angle), std::sin(angle)} * 60};
  };
  const auto mirrored = [](Line line) { return Line{{-line.a.x, line.a.y}, {-line.b.x, line.b.y}}; };
  for (const Solid& solid : kSolids) {
    for (const int left : {59, 75, 90, 100}) {
      for (const int right : {52, 60, 80}) {
        for (const int gap : {0, 9}) {
          const Line rightLine = side(right, gap);
          const Line leftLine = mirrored(side(left, gap));
          addIfValid(cases, solid.word + text("Left%dRight%dGap%d", left, right, gap),
                     levelText(solid, "0 30 0", lineOf(leftLine.a, leftLine.b) + lineOf(rightLine.a, rightLine.b)));
        }
      }
    }
  }
  return cases;
}

const char* kWords[] = {"",      "",      "",       "oneway", "hazard",  "checkpoint", "up 0",        "up 1",
                        "key 0", "key 1", "door 0", "door 1", "plate 2", "door 2",     "timed 40 25", "timed 7 90"};

// Lines of all words anywhere on all faces, many short, and a floor under the start.
std::vector<Case> anything(std::uint64_t count) {
  std::vector<Case> cases;
  for (std::uint64_t i = 0; cases.size() < count; ++i) {
    sim::SeededRandom random(kSeed * 1000 + i);
    const Solid& solid = kSolids[random.below(std::size(kSolids))];
    const int size = 200 + static_cast<int>(random.below(200));
    const int faces = PlatonicSolid::of(solid.kind).faces();
    const auto coordinate = [&] {
      return static_cast<double>(random.below(static_cast<std::uint64_t>(size))) - size / 2.0;
    };
    std::string level = solid.word + text("\n0 0 0 0\n%d 0 0\n%d\n", faces - 1, size);
    for (int face = 0; face < faces; ++face) {
      level += "%\n";
      if (face == 0) level += "-40 -30 40 -30\n";
      if (face == faces - 1) level += kWalls;
      for (auto lines = 2 + random.below(10); lines > 0; --lines) {
        const Vec a{coordinate(), coordinate()};
        const Vec b = random.below(2) == 0 ? Vec{coordinate(), coordinate()}
                                           : a + Vec{coordinate() / 6 + 1, random.below(2) == 0 ? 0 : coordinate() / 6};
        level += lineOf(a, b, kWords[random.below(std::size(kWords))]);
      }
    }
    addIfValid(cases, text("Level%d", static_cast<int>(i)), level);
  }
  return cases;
}

// Rooms in a row on one floor of the cube, each behind a door; the keys lie in any order, some beside the start and
// some behind other doors, and some doors are also above the way.
std::vector<Case> keys() {
  std::vector<Case> cases;
  for (int order = 0; order < 24; ++order) {
    int places[] = {-150, 10, 90, 170};
    sim::SeededRandom random(static_cast<std::uint64_t>(order) + 77);
    for (std::size_t i = 3; i > 0; --i) std::swap(places[i], places[random.below(i + 1)]);
    std::string lines = "-240 -200 240 -200\n-240 -100 240 -100\n";
    for (int number = 0; number < 3; ++number) {
      lines += text("%d -200 %d -100 door %d\n", -30 + 80 * number, -30 + 80 * number, number);
      lines += text("%d -180 %d -170 %s %d\n", places[number], places[number],
                    number == 2 && order % 2 ? "plate" : "key", number);
    }
    // A key behind an edge, and a door where the way back from there ends.
    const std::string behind = "-240 -200 0 -200\n-100 -180 -100 -170 key 3\n";
    lines += "-120 -200 -120 -100 door 3\n";
    std::string level = "HEXAHEDRON\n0 -80 -180 0\n5 0 0\n480\n%\n" + lines;
    for (int face = 1; face < 6; ++face) level += "%\n" + (face == 5 ? kWalls : behind);
    addIfValid(cases, text("Order%d", order), level);
  }
  return cases;
}

std::vector<Case> shipped() {
  std::vector<Case> cases;
  for (const std::string& file : solidLevels()) cases.push_back({text("Level%zu", cases.size()), readText(file)});
  return cases;
}

// A third of them in a brief run.
std::vector<Case> some(const std::vector<Case>& cases) {
  std::vector<Case> chosen;
  for (std::size_t i = 0; i < cases.size(); i += isBrief() ? 3 : 1) chosen.push_back(cases[i]);
  return chosen;
}

TEST(ReachLawCases, HaveAllWords) {
  for (const ElementKind kind : kElementKinds) {
    EXPECT_TRUE(std::any_of(std::begin(kWords), std::end(kWords),
                            [&](std::string_view word) { return word.substr(0, word.find(' ')) == wordOf(kind); }))
        << "add '" << wordOf(kind) << "' to kWords: what Reach proves of it would not be tried";
  }
}

// Rooms that an element parts from side to side or into two floors, with the start in one half and the goal in the
// other.
std::vector<std::string> roomsOf(const std::string& word) {
  std::vector<std::string> rooms;
  const std::string walls = "-150 -200 150 -200\n-150 -200 -150 240\n150 -200 150 240\n";
  const auto add = [&](const char* start, const char* goal, const char* ends) {
    rooms.push_back(text("HEXAHEDRON\n0 %s 0\n0 %s\n480\n%%\n", start, goal) + walls + ends + " " + word +
                    "\n%\n%\n%\n%\n%\n");
  };
  for (const char* const ends : {"0 -200 0 240", "0 240 0 -200"}) add("-30 -180", "30 -180", ends);
  for (const char* const ends : {"-150 0 150 0", "150 0 -150 0"}) {
    add("0 20", "0 -150", ends);
    add("0 20", "0 60", ends);
  }
  return rooms;
}

// All, but of doors, of which none differs from another, the first and the last, and of timed segments some.
std::vector<std::uint32_t> numbersToTry(ElementKind kind) {
  const NumberRange range = rangeOf(kind, 4);
  if (traitsOf(kind).number == ElementNumber::kDoor) return {range.first, range.last};
  if (traitsOf(kind).number == ElementNumber::kTicks) return {10, 40, 200};
  std::vector<std::uint32_t> numbers(range.last + 1);
  std::iota(numbers.begin(), numbers.end(), 0U);
  return numbers;
}

bool isSolved(const std::string& room) { return LevelSolver(levelOf(room)).solve({.states = 1000}).has_value(); }

// So the law below tries each of them: the search is long enough for its way, through the element or over it.
TEST(ReachLawCases, EveryRoomIsSolvedWithWhatBlocksNobodyOrEverybody) {
  const std::vector<std::string> open = roomsOf("checkpoint");
  const std::vector<std::string> closed = roomsOf("plate 0");
  for (std::size_t i = 0; i < open.size(); ++i) EXPECT_TRUE(isSolved(open[i]) || isSolved(closed[i])) << open[i];
}

// A kind that Reach takes for a wall though a player can pass it would be a false proof.
TEST(ReachLawCases, WhatASearchReachesIsReachableInRoomsOfEveryKind) {
  for (const ElementKind kind : kElementKinds) {
    for (const std::uint32_t number : numbersToTry(kind)) {
      for (const std::string& room : roomsOf(sampleWord(kind, static_cast<std::uint16_t>(number)).text())) {
        if (!isSolved(room)) continue;
        EXPECT_TRUE(Reach(*levelOf(room), kMaxCrossings).crossingsToGoal())
            << "a player passes what describe() in levels/reach/reach_walls.cpp takes for a wall:\n"
            << room;
      }
    }
  }
}

class ReachLawTest : public testing::TestWithParam<Case> {};

TEST_P(ReachLawTest, NobodyGetsFarther) {
  const auto level = levelOf(GetParam().text);
  const Reach reach(*level, kMaxCrossings);
  // What needs as many crossings as the goal, or more, is not searched.
  const int searched = std::min(kMaxCrossings + 1, reach.crossingsToGoal().value_or(kMaxCrossings + 1));
  Explorer explorer(level, kSeed);
  bool holds = true;
  explorer.play(exploredTicks(), [&](const Game& game, int crossings) {
    if (crossings >= searched || !holds) return false;
    const EntityState& player = game.world().entities()[0];
    const auto least = reach.crossingsTo(player.part, player.position, player.angle);
    holds = least && *least <= crossings;
    EXPECT_TRUE(holds) << "tick " << game.tick() << ": face " << player.part << " at " << player.position.x / 1024.0
                       << " " << player.position.y / 1024.0 << ", up " << player.angle.centidegrees() / 100 << ", "
                       << crossings << " crossings, doors " << game.openDoors() << ", in Reach " << least.value_or(-1)
                       << "\n"
                       << GetParam().text;
    return holds;
  });
}

std::vector<ElementWord> keysOf(const Level& level) {
  std::vector<ElementWord> keys;
  for (const Element& element : level.elements) {
    if (element.kind == ElementKind::kKey) keys.push_back({element.kind, element.number});
  }
  return keys;
}

// Nor does one who touches no key, and so leaves their doors shut.
TEST_P(ReachLawTest, NobodyGetsFartherWithoutKeys) {
  const auto level = levelOf(GetParam().text);
  const std::vector<ElementWord> keys = keysOf(*level);
  if (keys.empty()) return;
  const Reach reach(*level, kMaxCrossings, keys);
  const JumpHeights heights(*level, {.without = keys});
  const int searched = std::min(kMaxCrossings + 1, reach.crossingsToGoal().value_or(kMaxCrossings + 1));
  const auto isTaken = [&](const Game& game) {
    return std::any_of(level->elements.begin(), level->elements.end(), [&](const Element& element) {
      return element.kind == ElementKind::kKey && game.isTaken(element);
    });
  };
  Explorer explorer(level, kSeed);
  bool holds = true;
  explorer.play(exploredTicks() / 4, [&](const Game& game, int crossings) {
    if (!holds || isTaken(game)) return false;
    const EntityState& player = game.world().entities()[0];
    const auto least = reach.crossingsTo(player.part, player.position, player.angle);
    holds = heights.reaches(player.part, player.position) && (crossings >= searched || (least && *least <= crossings));
    EXPECT_TRUE(holds) << "tick " << game.tick() << ": face " << player.part << " at " << player.position.x / 1024.0
                       << " " << player.position.y / 1024.0 << "\n"
                       << GetParam().text;
    return holds;
  });
}

const auto nameOf = [](const testing::TestParamInfo<Case>& test) { return test.param.name; };

INSTANTIATE_TEST_SUITE_P(Shipped, ReachLawTest, testing::ValuesIn(shipped()), nameOf);
INSTANTIATE_TEST_SUITE_P(Posts, ReachLawTest, testing::ValuesIn(some(posts())), nameOf);
INSTANTIATE_TEST_SUITE_P(Wedges, ReachLawTest, testing::ValuesIn(some(wedges())), nameOf);
INSTANTIATE_TEST_SUITE_P(Keys, ReachLawTest, testing::ValuesIn(keys()), nameOf);
INSTANTIATE_TEST_SUITE_P(Anything, ReachLawTest, testing::ValuesIn(anything(isBrief() ? 2 : 12)), nameOf);

}  // namespace
}  // namespace platon::reach_law_test
