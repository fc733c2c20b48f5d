// Several players of one machine over one connection, against the server's match.
#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "client/session/session.h"
#include "tests/levels/shipped_level.h"
#include "tests/net/support/pressing.h"
#include "tests/net/support/session_network.h"
#include "tests/support/files.h"
#include "tests/support/test_levels.h"

namespace platon::companions_test {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr std::uint64_t kSeed = 20261128;

LinkQuality qualityOf(double delayMs, double jitterMs = 0, double loss = 0) {
  LinkQuality quality;
  quality.delayMs = delayMs;
  quality.jitterMs = jitterMs;
  quality.lossPercent = loss;
  return quality;
}

// A level whose way two players go, and how they go it: from the tick on in which both are there.
class TwoPlayers {
 public:
  explicit TwoPlayers(const std::string& file) : shipped_(file) {}

  const std::shared_ptr<const Level>& level() const { return shipped_.level(); }
  Controls controls() const {
    return [this, begun = std::make_shared<std::optional<std::uint32_t>>()](const Game& game, std::uint32_t slot) {
      const bool both = game.slots() >= 2 && game.player(0).present != 0 && game.player(1).present != 0;
      if (!both) {
        begun->reset();
        return Input();
      }
      if (!*begun) *begun = game.tick();
      const std::uint32_t tick = game.tick() - **begun + 1;  // in the first one, both came
      return tick < shipped_.way().size() ? shipped_.way()[tick].at(slot) : Input();
    };
  }

 private:
  ShippedLevel shipped_;
};

bool isReached(const Session& session) {
  if (session.round() == nullptr) return false;
  const Game& game = session.round()->prediction().confirmed();
  for (std::uint32_t slot = 0; slot < game.slots(); ++slot)
    if (game.player(slot).finished()) return true;
  return false;
}

class CoopLevel : public testing::TestWithParam<const char*> {};

TEST_P(CoopLevel, IsFinishedByTwoPlayersOfOneMachine) {
  const TwoPlayers two(std::string("levels/data/") + GetParam() + ".level");
  SessionNetwork match({two.level()}, kSeed);
  const std::size_t client = match.join(qualityOf(40), two.controls());
  match.session(client).setCompanion(1, "Ben");
  for (int i = 0; i < 40 && !isReached(match.session(client)); ++i) match.run(milliseconds(500));
  EXPECT_TRUE(isReached(match.session(client)));
  EXPECT_EQ(match.session(client).predictionStatistics().corrections, 0U) << "both are predicted";
}

INSTANTIATE_TEST_SUITE_P(Shipped, CoopLevel,
                         testing::Values("hexahedron/06_hold_the_door", "tetrahedron/12_back_to_back",
                                         "octahedron/18_after_you"),
                         [](const auto& each) {
                           return std::string(each.param).substr(std::string(each.param).find('/') + 4);
                         });

TEST(Companions, NoneNeedsACorrectionOnAConstantConnection) {
  SessionNetwork match({endlessLevel()}, kSeed);
  const std::size_t client = match.join(qualityOf(60), pressing(kSeed));
  match.join(qualityOf(20), pressing(kSeed + 1));
  match.run(seconds(3));
  for (std::uint32_t local = 1; local < kMaxLocalPlayers; ++local)
    match.session(client).setCompanion(local, "Player " + std::to_string(local));
  match.run(seconds(10));
  for (const std::optional<std::uint32_t>& slot : match.session(client).slots()) ASSERT_TRUE(slot);
  const PredictionStatistics before = match.session(client).predictionStatistics();
  match.run(seconds(10));
  const PredictionStatistics gained = match.session(client).predictionStatistics() - before;
  EXPECT_GT(gained.confirmedTicks, 590U);
  EXPECT_EQ(gained.missedInputs, 0U);
  EXPECT_EQ(gained.corrections, 0U);
  EXPECT_EQ(gained.mispredicted, 0U);
}

TEST(Companions, StayInLockstepUnderLossAndJitterWhileTheyComeAndGo) {
  SessionNetwork match({endlessLevel()}, kSeed);
  const std::size_t first = match.join(qualityOf(60, 40, 10), pressing(kSeed));
  const std::size_t second = match.join(qualityOf(30, 20, 5), pressing(kSeed + 1));
  for (std::uint32_t i = 0; i < 12; ++i) {
    match.run(seconds(3));
    match.session(first).setCompanion(1 + i % 3, i % 2 == 0 ? std::optional<std::string>("Ann") : std::nullopt);
    match.session(second).setCompanion(1, i % 4 < 2 ? std::optional<std::string>("Ann") : std::nullopt);
  }
  for (const std::size_t client : {first, second}) {
    EXPECT_EQ(match.session(client).roundStatistics().desyncs, 0U);
    EXPECT_FALSE(match.session(client).ending());
  }
}

TEST(Companions, ResumeTogetherInTheirSlots) {
  SessionNetwork match({endlessLevel()}, kSeed);
  const std::size_t client = match.join(qualityOf(30), pressing(kSeed));
  match.session(client).setCompanion(1, "Ben");
  match.session(client).setCompanion(3, "Cid");
  match.run(seconds(2));
  const SlotsByLocal slots = match.session(client).slots();
  ASSERT_TRUE(slots[1] && !slots[2] && slots[3]);
  match.disconnect(client, milliseconds(300));
  match.run(seconds(2));
  match.resume(client);
  match.run(seconds(3));
  EXPECT_EQ(match.session(client).slots(), slots);
  EXPECT_EQ(match.session(client).names()[*slots[3]], "Cid");
  EXPECT_EQ(match.session(client).round()->prediction().slots(), slots);
}

TEST(Companions, AreForgottenWhereAServerHasNoRoom) {
  SessionNetwork match({endlessLevel()}, kSeed, 2);
  const std::size_t client = match.join(qualityOf(30), pressing(kSeed));
  match.session(client).setCompanion(1, "Ben");
  match.session(client).setCompanion(2, "Cid");
  match.run(seconds(2));
  EXPECT_TRUE(match.session(client).slots()[1]);
  EXPECT_FALSE(match.session(client).slots()[2]);
  EXPECT_EQ(match.session(client).companions(), (NamesByLocal{{{}, "Ben"}}));
  EXPECT_EQ(match.session(client).takeNotice(), "the server is full (2 players): try again later");
}

}  // namespace
}  // namespace platon::companions_test
