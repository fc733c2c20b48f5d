#include "tests/exactness/reference/terrain_judge.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/exactness/reference/ideal_path.h"
#include "tests/exactness/reference/simulated_body.h"
#include "tests/exactness/reference/terrain.h"

namespace platon::reference::terrain_judge_test {
namespace {

constexpr std::int64_t kTicks = 300;

/// The ideal body with an error that is a function of the tick.
class WrongBody : public JudgedBody {
 public:
  using Error = RationalVec (*)(std::int64_t tick);

  WrongBody(const ExactScene& scene, Error error) : ideal_(scene, kTicks), error_(error) {}

  void tick() override { ++tick_; }
  RationalVec position() const override {
    const RationalVec at = precisePosition();
    return {rounded(at.x), rounded(at.y)};
  }
  RationalVec precisePosition() const override {
    const RationalVec at = ideal_.positionAt(tick_);
    const RationalVec error = error_(tick_);
    return {at.x + error.x, at.y + error.y};
  }

 private:
  static mpq_class rounded(const mpq_class& value) {
    mpz_class result;
    const mpq_class half = value + mpq_class(1, 2);
    mpz_fdiv_q(result.get_mpz_t(), half.get_num_mpz_t(), half.get_den_mpz_t());
    return mpq_class(result);
  }

  IdealPath ideal_;
  Error error_;
  std::int64_t tick_ = 0;
};

/// A box of 2048 that slides on a long slope.
ExactScene slope() {
  return {{{-1024, -1024}, {1024, -1024}, {1024, 1024}, {-1024, 1024}},
          {{{-9000, -3000}, {900000, 300000}}},
          {0, 5000},
          {700, -300}};
}

Verdict judged(WrongBody::Error error) {
  WrongBody body(slope(), error);
  return judge(slope(), kTicks, body);
}

TEST(TerrainJudgeTest, TheRoundedIdealBodyHolds) {
  const Verdict verdict = judged([](std::int64_t) { return RationalVec{}; });
  EXPECT_TRUE(verdict.counts());
  EXPECT_TRUE(verdict.holds());
  EXPECT_EQ(verdict.tie.kind, Tie::Kind::kNone);
  EXPECT_EQ(verdict.judgedTicks, kTicks);
  EXPECT_EQ(verdict.maxPrecise, 0);
  EXPECT_GT(verdict.maxLattice, 0.4);
  EXPECT_LE(verdict.maxLattice, std::sqrt(0.5));
  EXPECT_EQ(verdict.idealLegs, 2u);
  EXPECT_FALSE(verdict.restsAt);
}

TEST(TerrainJudgeTest, FindsABodyThatIsShiftedByThreeSubunits) {
  const Verdict verdict = judged([](std::int64_t) { return RationalVec{3, 0}; });
  EXPECT_FALSE(verdict.holds());
  EXPECT_EQ(verdict.firstAbove, 1);
  EXPECT_DOUBLE_EQ(verdict.maxPrecise, 3);
}

TEST(TerrainJudgeTest, FindsABodyThatIsShiftedForOneTick) {
  const Verdict verdict = judged([](std::int64_t tick) { return RationalVec{tick == 200 ? 5 : 0, 0}; });
  EXPECT_EQ(verdict.firstAbove, 200);
  EXPECT_DOUBLE_EQ(verdict.maxPrecise, 5);
}

/// A slide that is truncated falls behind by a part of a subunit in every tick.
TEST(TerrainJudgeTest, FindsABodyThatFallsBehind) {
  const Verdict verdict = judged([](std::int64_t tick) { return RationalVec{mpq_class(-tick, 50), 0}; });
  EXPECT_DOUBLE_EQ(verdict.maxPrecise, 6);
  EXPECT_GT(verdict.firstAbove, 50);
  EXPECT_LT(verdict.firstAbove, 140);
}

TEST(TerrainJudgeTest, JudgesNothingAfterATie) {
  const ExactScene diamond = {{{0, -1000}, {1000, 0}, {0, 1000}, {-1000, 0}},
                              {{{0, -5000}, {0, -5000}}, {{-90000, -60000}, {90000, -60000}}},
                              {0, 0},
                              {0, -400}};
  WrongBody body(diamond, [](std::int64_t) { return RationalVec{9, 9}; });
  const Verdict verdict = judge(diamond, kTicks, body);
  EXPECT_EQ(verdict.tie.kind, Tie::Kind::kDivided);
  EXPECT_EQ(verdict.judgedTicks, 0);
  EXPECT_TRUE(verdict.holds());
}

TEST(TerrainJudgeTest, ASceneWithoutContactAtTheEndDoesNotCount) {
  ExactScene scene = slope();
  scene.velocity = {700, 1};
  scene.lines.push_back({{0, -50000}, {9, -50000}});
  scene.start = {0, 400000};
  WrongBody body(scene, [](std::int64_t) { return RationalVec{}; });
  EXPECT_FALSE(judge(scene, kTicks, body).counts());
}

TEST(SimulatedBodyTest, MovesExactlyWhereNothingIsInTheWay) {
  SimulatedBody body(slope());
  for (int i = 0; i < 2; ++i) body.tick();
  EXPECT_EQ(body.position().x, 1400);
  EXPECT_EQ(body.position().y, 4400);
  EXPECT_EQ(body.precisePosition().x, 1400);
  EXPECT_EQ(body.legs(), 2);
}

TEST(SimulatedBodyTest, DistancesAreEuclidean) { EXPECT_EQ(distance({1, 2}, {4, 6}), 5); }

}  // namespace
}  // namespace platon::reference::terrain_judge_test
