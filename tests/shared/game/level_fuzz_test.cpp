#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <regex>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "platon/game/game.h"
#include "platon/game/level.h"
#include "tests/support/element_level.h"
#include "tests/support/run/repetitions.h"

namespace platon::level_fuzz_test {
namespace {

constexpr std::array<std::string_view, 5> kSeeds = {
    "# title: One\n# author: Two\nTETRAHEDRON\n0 0 0 60\n1 0 100\n400\n%\n-150.5 -60 150.25 -60\n-300 40 300 "
    "40.0001\n%\n"
    "0 0 50 50\n%\n\n-1000 -50 1000 -50 # cut\n%\n7 7 7 7\n",
    "HEXAHEDRON\r\n3 0 0 -90\r\n5 240 240\r\n480\r\n%\r\n-240 -240 240 -240\r\n%\r\n-240 0 0 240\r\n%\r\n%\r\n100 1 "
    "100 9\r\n%\r\n"
    "%\r\n-999 -999 999 999\r\n",
    "OCTAHEDRON\n7 0 -40 180\n0 0 200\n500\n%\n0 0 0 400\n%\n%\n%\n-250 -144.3376 250 -144.3376\n%\n%\n%\n0 288.6751 "
    "250 -144.3376\n%\n",
    "DODECAHEDRON\n11 0 0 36\n0 0 0\n65536\n%\n-40000 0 40000 0\n%\n%\n%\n%\n%\n%\n%\n%\n%\n-131072 5 131072 7\n%\n%\n"
    "32768.0001 -45101.2825 -32768 -45101.2828\n",
    "# crossings: 1\n# players: 2\nTETRAHEDRON\n0 0 -40 0\n1 0 0\n300\n%\n-90 -60 90 -60 oneway\n-90 -70 0 -70 plate "
    "1\n0 "
    "-70 90 -70\n%\n-20 0 20 0 checkpoint\n-90 -40 90 -40 hazard\n%\n-40 0 -40 40 key 1\n40 0 40 40 door 1\n%\n-99 9 "
    "99 9 "
    "up 2\n-50 -30 50 -30 timed 20 30\n"};

// What the mutator puts into a level.
constexpr std::array<std::string_view, 33> kPieces = {"%",
                                                      "\n",
                                                      "\r",
                                                      " ",
                                                      "\t",
                                                      "#",
                                                      "-",
                                                      ".",
                                                      "0",
                                                      "99999",
                                                      "240",
                                                      "-240",
                                                      "0.0001",
                                                      "1e9",
                                                      "%\n",
                                                      "0 0 0 0\n",
                                                      "ICOSAHEDRON",
                                                      "# title: x\n",
                                                      "-500 0 500 0\n",
                                                      "18446744073709551616",
                                                      "\xc3\xa9",
                                                      " oneway\n",
                                                      " up 2",
                                                      " hazard",
                                                      " checkpoint",
                                                      " key 31",
                                                      " door 0",
                                                      " plate 1",
                                                      " timed 60 60",
                                                      "# players: 9\n",
                                                      "# crossings: 0\n",
                                                      "# needs: key 1, plate 31, checkpoint\n",
                                                      "\xef\xbb\xbf"};

template <class Texts>
bool hasWord(const Texts& texts, ElementKind kind) {
  const std::regex word(" " + std::string(wordOf(kind)) + "\\b");
  return std::any_of(texts.begin(), texts.end(),
                     [&](std::string_view text) { return std::regex_search(text.begin(), text.end(), word); });
}

// A mutator does not invent a word.
TEST(LevelFuzzTest, SeedsAndPiecesHaveTheWordsOfAllKinds) {
  for (const ElementKind kind : kElementKinds) {
    EXPECT_TRUE(hasWord(kSeeds, kind)) << "add a segment with '" << wordOf(kind) << "' to kSeeds";
    EXPECT_TRUE(hasWord(kPieces, kind)) << "add '" << wordOf(kind) << "' to kPieces";
  }
}

TEST(ElementLevelTest, HasAllKindsOfElements) {
  std::set<ElementKind> kinds;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const LevelResult result = loadLevel(elementLevel(1, seed));
    if (!result.level) continue;
    for (const Element& element : result.level->elements) kinds.insert(element.kind);
  }
  for (const ElementKind kind : kElementKinds)
    EXPECT_TRUE(kinds.contains(kind)) << "add '" << wordOf(kind) << "' to tests/support/element_level.cpp";
}

class Mutator {
 public:
  explicit Mutator(unsigned seed) : random_(seed) {}

  std::string mutate(std::string text) {
    for (std::size_t i = 0; i <= below(4); ++i) change(text);
    return text;
  }

 private:
  std::size_t below(std::size_t limit) { return limit == 0 ? 0 : random_() % limit; }

  std::string piece() {
    if (below(4) == 0) return std::string(1, static_cast<char>(below(256)));
    return std::string(kPieces[below(kPieces.size())]);
  }

  void change(std::string& text) {
    const std::size_t at = below(text.size() + 1);
    const std::size_t length = std::min(below(12), text.size() - at);
    switch (below(5)) {
      case 0:
        text.insert(at, piece());
        break;
      case 1:
        text.erase(at, length);
        break;
      case 2:
        text.replace(at, length, piece());
        break;
      case 3:
        text.insert(below(text.size() + 1), text.substr(at, length));
        break;
      default:
        if (at < text.size()) text[at] = static_cast<char>(text[at] ^ static_cast<char>(1 << below(8)));
    }
  }

  std::mt19937 random_;
};

// Largest distance of a point outside an edge of the polygon, in subunits; negative inside the polygon.
long double beyond(const std::vector<Point>& polygon, Point point) {
  long double largest = -1e9L;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point edge = polygon[(i + 1) % polygon.size()] - polygon[i];
    const long double length = std::sqrt(static_cast<long double>(squaredLength(edge)));
    largest = std::max(largest, static_cast<long double>(-cross(edge, point - polygon[i])) / length);
  }
  return largest;
}

void expectValid(const Level& level, const std::string& text) {
  const auto polygon = facePolygon(level.solid, level.faceSize);
  ASSERT_EQ(level.segments.size(), static_cast<std::size_t>(PlatonicSolid::of(level.solid).faces()));
  for (const auto& face : level.segments) {
    for (const Segment& line : face) {
      ASSERT_LE(beyond(polygon, line.a), 1.0L) << text;
      ASSERT_LE(beyond(polygon, line.b), 1.0L) << text;
    }
  }
  for (const Element& element : level.elements) {
    ASSERT_EQ(level.segments.at(element.face).at(element.segment), element.ends) << text;
    ASSERT_EQ(findElement(level.elements, element.face, element.segment), &element) << text;
  }
  EXPECT_LT(level.startFace, level.segments.size());
  EXPECT_LT(level.goalFace, level.segments.size());
  EXPECT_LE(beyond(polygon, level.start), 0.0L) << text;
  EXPECT_LE(beyond(polygon, level.goal), 0.0L) << text;
  EXPECT_EQ(level.text, text);
}

void expectValid(const std::vector<Diagnostic>& diagnostics, const std::string& text) {
  const auto lines = std::max<std::ptrdiff_t>(1, std::count(text.begin(), text.end(), '\n') + 1);
  for (const Diagnostic& one : diagnostics) {
    EXPECT_GE(one.line, 1) << text;
    EXPECT_LE(one.line, lines) << text;
    EXPECT_GE(one.column, 1) << text;
    EXPECT_LE(one.column, static_cast<int>(text.size()) + 1) << text;
    EXPECT_TRUE(std::all_of(one.message.begin(), one.message.end(), [](char c) { return c >= ' ' && c <= '~'; }));
  }
  EXPECT_TRUE(std::is_sorted(diagnostics.begin(), diagnostics.end(), [](const auto& a, const auto& b) {
    return std::tie(a.line, a.column) < std::tie(b.line, b.column);
  })) << text;
}

TEST(LevelFuzzTest, AMutatedLevelIsRefusedOrValid) {
  constexpr unsigned seed = 31337;
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  Mutator mutator(seed);
  int valid = 0;
  int invalid = 0;
  for (int i = 0; i < repetitions(20000) && !testing::Test::HasFailure(); ++i) {
    const std::string text = mutator.mutate(std::string(kSeeds[static_cast<std::size_t>(i) % kSeeds.size()]));
    const LevelResult result = loadLevel(text);
    const bool error =
        std::any_of(result.diagnostics.begin(), result.diagnostics.end(), [](auto& one) { return one.error; });
    EXPECT_EQ(result.level == nullptr, error) << text;
    expectValid(result.diagnostics, text);
    if (result.level != nullptr) expectValid(*result.level, text);
    ++(result.level != nullptr ? valid : invalid);
  }
  EXPECT_GT(valid, repetitions(500));
  EXPECT_GT(invalid, repetitions(2000));
}

// A valid level can be played, wherever its elements are.
TEST(LevelFuzzTest, RandomElementsAreValidAndPlayed) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const std::string text = elementLevel(static_cast<int>(seed % kSolidKinds), seed);
    const LevelResult result = loadLevel(text);
    ASSERT_NE(result.level, nullptr) << format("seed " + std::to_string(seed), result.diagnostics.at(0));
    expectValid(*result.level, text);
    for (const ElementKind kind : {ElementKind::kOneway, ElementKind::kCheckpoint}) {
      const auto isOf = [&](const Element& element) { return element.kind == kind; };
      EXPECT_TRUE(std::any_of(result.level->elements.begin(), result.level->elements.end(), isOf)) << seed;
    }
    Game game(result.level);
    for (int tick = 0; tick < 100; ++tick) game.advance(std::vector<Input>(3, Input{Input::kPresent | Input::kRight}));
    Game restored(result.level);
    EXPECT_TRUE(restored.restore(game.save())) << seed;
  }
}

TEST(LevelFuzzTest, SeedsAreValidLevels) {
  for (const std::string_view seed : kSeeds) EXPECT_NE(loadLevel(seed).level, nullptr) << seed;
}

}  // namespace
}  // namespace platon::level_fuzz_test
