#include "tests/net/attacks/attack.h"

#include <gtest/gtest.h>

#include <algorithm>

#include <ostream>
#include <string>

#include "protocol/transport/sealed_channel.h"
#include "tests/net/attacks/virtual_attack.h"

namespace platon::attacks_test {

void PrintTo(const Attack& attack, std::ostream* stream) { *stream << attack.name; }

namespace {

constexpr std::int64_t kMaxHeapGrowth = 1024 * 1024;
// The server asks each of four victims at most twice a second, for four seconds, whether it still receives.
constexpr std::uint64_t kQuestionBytes = 4 * 4 * 2 * kPathChallengeBytes;

const Damage& withoutAttack() {
  static const Damage damage = attackVirtually(nullptr);
  return damage;
}

class AttackTest : public testing::TestWithParam<Attack> {};

// docs/security.md names what is promised.
TEST_P(AttackTest, DoesNoHarm) {
  const Damage& quiet = withoutAttack();
  const Damage damage = attackVirtually(&GetParam(), GetParam().name == "passwords" ? "sesame" : "");
  EXPECT_GE(damage.ticks, quiet.ticks * 99 / 100);
  EXPECT_LE(damage.missedInputs, quiet.missedInputs + damage.ticks / 1000);
  EXPECT_EQ(damage.disconnected, 0);
  EXPECT_EQ(damage.desyncs, 0u);
  EXPECT_EQ(damage.rounds, quiet.rounds);
  ASSERT_TRUE(damage.joinTime);
  EXPECT_LE(*damage.joinTime, std::chrono::seconds(2));
  EXPECT_LE(damage.heapGrowth, quiet.heapGrowth + kMaxHeapGrowth);
  EXPECT_EQ(damage.amplified, 0u);
  EXPECT_LE(damage.maxPlayers, 5u + kOwnHouseholds * AttackedServer::kPlayersPerAddress);
  if (!GetParam().proves) {
    EXPECT_EQ(damage.heldPlaces, 0u);
    EXPECT_EQ(damage.maxPlayers, 5u);
    EXPECT_LE(damage.bytesToVictims, quiet.bytesToVictims * 101 / 100 + damage.bytesAsVictims + kQuestionBytes);
  }
  EXPECT_LE(damage.late.received - damage.late.ticks, kMaxAmplification * damage.late.sent);
  EXPECT_EQ(damage.late.ticks > 0, GetParam().amplifies);
  EXPECT_GT(damage.sent, 0u);
  const std::string reason(GetParam().reason);
  if (!reason.empty()) {
    EXPECT_GT(damage.rejected.at(reason), 0u);
  }
}

INSTANTIATE_TEST_SUITE_P(All, AttackTest, testing::ValuesIn(attacks().begin(), attacks().end()), [](const auto& each) {
  std::string name(each.param.name);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

}  // namespace
}  // namespace platon::attacks_test
