#include "tests/exactness/oracle/sweep/sweep_oracle.h"

#include <gtest/gtest.h>

#include "tests/exactness/oracle/sweep/sweep_families.h"

namespace platon::oracle::sweep_oracle_test {
namespace {

const Polygon kSquare{{0, 0}, {10, 0}, {10, 10}, {0, 10}};

std::string correctText(const SweepQuery& query) {
  const CorrectAnswer found = correctAnswer(query);
  EXPECT_TRUE(confirms(query, found)) << toLine(query);
  return toText(found);
}

TEST(SweepOracle, HitsASegment) {
  EXPECT_EQ(correctText({kSquare, {0, 0}, {20, 0}, {{15, -50}, {15, 50}}}), "hit 550 2200 -110 0");
}

TEST(SweepOracle, MissesASegmentTouchedAtTheEnd) {
  EXPECT_EQ(correctText({kSquare, {0, 0}, {5, 0}, {{15, -50}, {15, 50}}}), "miss");
  EXPECT_EQ(correctText({kSquare, {0, 0}, {6, 0}, {{15, -50}, {15, 50}}}), "hit 550 660 -110 0");
}

TEST(SweepOracle, MissesASegmentItSlidesAlong) {
  EXPECT_EQ(correctText({kSquare, {0, 0}, {50, 0}, {{-50, 0}, {90, 0}}}), "miss");
  EXPECT_EQ(correctText({kSquare, {0, 0}, {50, -1}, {{-50, 0}, {90, 0}}}), "hit 0 150 0 150");
}

TEST(SweepOracle, ReportsAPointInsideAsOverlap) {
  EXPECT_EQ(correctText({kSquare, {0, 0}, {50, 0}, {{5, 5}, {5, 5}}}), "hit 0 1 0 0");
  EXPECT_EQ(correctText({kSquare, {0, 0}, {0, 0}, {{5, 5}, {5, 5}}}), "hit 0 1 0 0");
  EXPECT_EQ(correctText({kSquare, {0, 0}, {0, 0}, {{0, 5}, {0, 5}}}), "miss");
}

TEST(SweepOracle, AcceptsBothEdgesOfAVertex) {
  EXPECT_EQ(correctText({kSquare, {0, 0}, {20, 20}, {{15, 15}, {15, 15}}}), "hit 200 800 -10 0 | 0 -10");
}

TEST(SweepOracle, AcceptsOnlyTheEnteredEdgeOfAVertex) {
  const SweepQuery query{kSquare, {0, 0}, {0, 20}, {{10, 20}, {20, 15}}};
  EXPECT_EQ(correctText({kSquare, {0, 0}, {20, 20}, {{15, 15}, {25, 10}}}), "hit 200 800 -10 0 | -5 -10");
  EXPECT_EQ(correctText(query), "miss");
}

TEST(SweepOracle, ComparesTimesAsRationalsAndNormalsAsDirections) {
  const CorrectAnswer expected = correctAnswer({kSquare, {0, 0}, {20, 0}, {{15, -50}, {15, 50}}});
  const auto isCorrect = [&](const char* line) { return agrees(expected, parseAnswer(line).value()); };
  EXPECT_TRUE(isCorrect("hit 1 4 -1 0"));
  EXPECT_TRUE(isCorrect("hit 25 100 -7 0"));
  EXPECT_FALSE(isCorrect("hit -1 -4 -1 0"));
  EXPECT_FALSE(isCorrect("hit 1 4 1 0"));
  EXPECT_FALSE(isCorrect("hit 1 4 0 0"));
  EXPECT_FALSE(isCorrect("hit 1 4 -1 1"));
  EXPECT_FALSE(isCorrect("hit 26 100 -7 0"));
  EXPECT_FALSE(isCorrect("miss"));
  EXPECT_FALSE(isCorrect("hit 0 1 0 0"));
}

TEST(SweepOracle, ParsesOnlyExactAnswers) {
  EXPECT_TRUE(parseAnswer("miss"));
  EXPECT_TRUE(parseAnswer("hit 0 1 0 0"));
  for (const char* line : {"", "Miss", "miss ", "hit", "hit 0 1 0", "hit 0 1 0 0 0", "hit 0 1 0 0 ", "hit 0 1 0 x"})
    EXPECT_FALSE(parseAnswer(line)) << line;
}

TEST(SweepOracle, ConfirmsNoWrongAnswer) {
  const SweepQuery query{kSquare, {0, 0}, {20, 0}, {{15, -50}, {15, 50}}};
  const CorrectAnswer right = correctAnswer(query);
  CorrectAnswer wrong = right;
  wrong.numerator += 1;
  EXPECT_FALSE(confirms(query, wrong));
  wrong = right;
  wrong.numerator -= 1;
  EXPECT_FALSE(confirms(query, wrong));
  wrong = right;
  wrong.normals = {{-1, 1}};
  EXPECT_FALSE(confirms(query, wrong));
  EXPECT_FALSE(confirms(query, CorrectAnswer{}));
  EXPECT_FALSE(confirms(query, {CorrectAnswer::Kind::Overlap, 0, 1, {}}));
}

TEST(SweepOracle, SatisfiesTheDefinition) {
  constexpr std::uint64_t kSeed = 5;
  RandomSource random(kSeed);
  for (const SweepFamily& family : sweepFamilies())
    for (int i = 0; i < 300; ++i) {
      const SweepQuery query = makeQuery(family, random);
      ASSERT_TRUE(confirms(query, correctAnswer(query))) << "seed " << kSeed << ": " << toLine(query);
    }
}

}  // namespace
}  // namespace platon::oracle::sweep_oracle_test
