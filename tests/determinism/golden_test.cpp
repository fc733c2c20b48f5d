// Every build on every machine replays the golden recordings bit by bit.
#include <gtest/gtest.h>

#include <set>

#include "platon/game/recording_reader.h"
#include "tests/determinism/lockstep_levels.h"
#include "tests/sim/verify/verification.h"

namespace platon::sim::golden_test {
namespace {

std::vector<std::string> goldenRecordings() { return filesIn("tests/determinism/golden", ".recording"); }

class GoldenTest : public testing::TestWithParam<std::string> {};

TEST_P(GoldenTest, ReplaysTheSameGame) {
  const auto bytes = readBytes(GetParam());
  const Verification found = Verifier(bytes).run();
  EXPECT_EQ(found.fault, "");
  EXPECT_GE(found.ticks, 1800u);
  EXPECT_EQ(found.slots, 8u);
  ASSERT_FALSE(found.divergence)
      << "desync at tick " << found.divergence->tick
      << ". If the rules were changed on purpose, raise kRulesVersion in shared/include/platon/game/game.h and run "
         "tests/determinism/golden/record.sh; otherwise the change broke the game.";
}

INSTANTIATE_TEST_SUITE_P(All, GoldenTest, testing::ValuesIn(goldenRecordings()),
                         [](const auto& file) { return testName(file.param); });

TEST(GoldenFilesTest, EveryLevelHasARecordingOfItsCurrentText) {
  std::set<std::uint64_t> recorded;
  for (const std::string& path : goldenRecordings()) {
    const auto bytes = readBytes(path);
    const RecordingReader reader(bytes);
    ASSERT_TRUE(reader.level()) << path << ": " << reader.fault();
    recorded.insert(reader.level()->hash);
  }
  for (const std::string& path : lockstepLevels()) {
    EXPECT_TRUE(recorded.contains(levelFrom(path)->hash))
        << path << " has no golden recording: run tests/determinism/golden/record.sh";
  }
  EXPECT_EQ(recorded.size(), lockstepLevels().size());
}

TEST(GoldenFilesTest, AllKindsOfElementsAreRecorded) {
  for (const std::string name : {"words", "elements"}) {
    const auto level = levelFrom("tests/determinism/golden/levels/" + name + ".level");
    std::set<ElementKind> kinds;
    for (const Element& element : level->elements) kinds.insert(element.kind);
    for (const ElementKind kind : kElementKinds) {
      EXPECT_TRUE(kinds.contains(kind)) << "add '" << wordOf(kind) << "' to " << name
                                        << "() in tests/determinism/golden/make_levels.py, and run record.sh";
    }
  }
}

TEST(GoldenFilesTest, PlayersCrossEdgesAndHaveSeveralInstances) {
  std::uint64_t crossings = 0;
  std::size_t maxInstances = 0;
  for (const std::string& path : goldenRecordings()) {
    const auto bytes = readBytes(path);
    Verifier verifier(bytes);
    verifier.run([&](std::span<const Input>, const Game& game) {
      maxInstances = std::max(maxInstances, game.world().state().instances.size());
    });
    for (const EntityState& entity : verifier.game()->world().entities()) crossings += entity.crossings;
  }
  EXPECT_GT(crossings, 500u);
  EXPECT_GT(maxInstances, 8u);
}

}  // namespace
}  // namespace platon::sim::golden_test
