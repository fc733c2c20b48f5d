#include "levels/drawing/typeface.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

namespace platon::typeface_test {
namespace {

using Kind = Typeface::OutlineStep::Kind;

TEST(Typeface, DecodesValidText) {
  EXPECT_EQ(codePointsOf("aé€😀"), U"aé€😀");
  EXPECT_EQ(codePointsOf(""), U"");
}

TEST(Typeface, ReplacesEveryInvalidByte) {
  EXPECT_EQ(codePointsOf("a\x80z"), U"a\uFFFDz");
  EXPECT_EQ(codePointsOf("\xC3"), U"\uFFFD");
  EXPECT_EQ(codePointsOf("\xC3("), U"\uFFFD(");
  EXPECT_EQ(codePointsOf("\xC0\xAF"), U"\uFFFD\uFFFD") << "overlong";
  EXPECT_EQ(codePointsOf("\xE0\x80\xAF"), U"\uFFFD\uFFFD\uFFFD") << "overlong";
  EXPECT_EQ(codePointsOf("\xED\xA0\x80"), U"\uFFFD\uFFFD\uFFFD") << "surrogate";
  EXPECT_EQ(codePointsOf("\xF4\x90\x80\x80"), U"\uFFFD\uFFFD\uFFFD\uFFFD") << "beyond Unicode";
  EXPECT_EQ(codePointsOf("\xFF"), U"\uFFFD");
}

TEST(Typeface, OmitsControlCharacters) { EXPECT_EQ(codePointsOf("a\n\x7F\xC2\x85z"), U"az"); }

TEST(Typeface, WidthIsTheSumOfTheAdvances) {
  const Typeface face;
  EXPECT_NEAR(face.width("Ab"), face.advance(U'A') + face.advance(U'b'), 1e-6);
  EXPECT_GT(face.width("WW"), face.width("ii"));
}

TEST(Typeface, OutlinesAreClosedCurves) {
  const Typeface face;
  for (const char32_t point : U"09AZaz·é") {
    if (point == 0) continue;
    const std::vector<Typeface::OutlineStep> outline = face.outline(point);
    ASSERT_FALSE(outline.empty());
    ASSERT_EQ(outline.front().kind, Kind::kMove);
    glm::vec2 first(0);
    for (std::size_t i = 0; i < outline.size(); ++i) {
      if (outline[i].kind == Kind::kMove) first = outline[i].to;
      const bool last = i + 1 == outline.size() || outline[i + 1].kind == Kind::kMove;
      EXPECT_TRUE(!last || outline[i].to == first) << static_cast<unsigned>(point);
    }
  }
  EXPECT_TRUE(face.outline(U' ').empty());
}

TEST(Typeface, OutlinesStandOnTheBaselineAndHaveTheStatedHeight) {
  const Typeface face;
  float low = 1;
  float high = -1;
  for (const Typeface::OutlineStep& step : face.outline(U'H')) {
    low = std::min(low, step.to.y);
    high = std::max(high, step.to.y);
    EXPECT_GE(step.to.x, 0);
    EXPECT_LE(step.to.x, face.advance(U'H'));
  }
  EXPECT_NEAR(low, 0, 1e-6);
  EXPECT_NEAR(high, Typeface::kCapitalHeight, 1e-3);
}

TEST(Typeface, DigitsHaveOneAdvanceAndStandInItsMiddle) {
  const Typeface face;
  for (char32_t digit = U'0'; digit <= U'9'; ++digit) {
    EXPECT_EQ(face.advance(digit), face.advance(U'0'));
    float left = 1;
    float right = 0;
    for (const Typeface::OutlineStep& step : face.outline(digit)) {
      left = std::min(left, step.to.x);
      right = std::max(right, step.to.x);
    }
    EXPECT_NEAR(left, face.advance(digit) - right, 0.1F) << static_cast<unsigned>(digit);
    EXPECT_GE(left, -0.01F);
  }
  EXPECT_EQ(face.width("11:11.11"), face.width("48:30.96"));
}

TEST(Typeface, HasWhatTheGameWrites) {
  const Typeface face;
  const auto missing = face.outline(U'\uE000');
  for (const char32_t point : std::u32string(U"09AZazéß…–−±×·✓✗★☆←→↑↓↖↗↘↙‹›Жω")) {
    EXPECT_NE(face.outline(point), missing) << static_cast<unsigned>(point);
    EXPECT_GT(face.advance(point), 0);
  }
}

TEST(Typeface, AMissingGlyphHasTheOutlineOfABox) {
  const Typeface face;
  EXPECT_FALSE(face.outline(U'\uE000').empty());
  EXPECT_EQ(face.outline(U'\uE000'), face.outline(U'\uE001'));
}

}  // namespace
}  // namespace platon::typeface_test
