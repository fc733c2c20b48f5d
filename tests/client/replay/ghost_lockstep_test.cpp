// Runs and ghosts only watch: a match in which clients have them is the same match, bit by bit.
#include <gtest/gtest.h>

#include <chrono>
#include <vector>

#include "client/replay/run_keeper.h"
#include "tests/client/replay/replay_of.h"
#include "tests/net/support/session_network.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_levels.h"

namespace platon::ghost_lockstep_test {
namespace {

using std::chrono::milliseconds;

constexpr std::uint64_t kSeed = 20260228;
constexpr int kFrames = 2400;

// Runs to the right, jumps now and then, and begins anew every six seconds.
Input controls(const Game& game, std::uint32_t slot) {
  const std::uint32_t tick = game.tick() + 40 * slot;
  if (tick % 360 < 2) return {Input::kRestart};
  if (tick % 360 < 30) return {};
  return {static_cast<std::uint8_t>(Input::kRight | (tick % 50 < 9 ? Input::kJump : 0))};
}

struct Watcher {
  std::shared_ptr<RunKeeper> keeper;
  std::size_t ghosts = 0;  // that were drawn

  void watch(const Session& session) {
    if (!keeper || session.round() == nullptr) return;
    const Prediction& prediction = session.round()->prediction();
    ghosts += keeper->ghostsAt(prediction.predicted(), prediction.slot(), 0.5).size();
    keeper->status();
  }
};

// Hashes of the server's game. SessionNetwork checks that the confirmed games of the clients are equal to it.
std::vector<std::uint64_t> play(std::vector<Watcher>& watchers) {
  SessionNetwork match({cornerLevel(), flatLevel()}, kSeed);
  LinkQuality quality;
  quality.delayMs = 40;
  quality.jitterMs = 20;
  quality.lossPercent = 3;
  for (const Watcher& watcher : watchers) match.join(quality, controls, watcher.keeper);
  std::vector<std::uint64_t> hashes;
  for (int frame = 0; frame < kFrames; ++frame) {
    match.run(milliseconds(16));
    hashes.push_back(match.match().game().hash());
    for (std::size_t i = 0; i < watchers.size(); ++i) watchers[i].watch(match.session(i));
  }
  return hashes;
}

TEST(GhostLockstep, AMatchWithGhostsIsTheSameMatch) {
  const TemporaryFolder folder;
  std::vector<Watcher> none(3);
  std::vector<Watcher> watchers(3);
  for (std::size_t i = 0; i < watchers.size(); ++i) {
    watchers[i].keeper = std::make_shared<RunKeeper>(RunStore(folder / std::to_string(i)), folder / "0");
  }
  EXPECT_EQ(play(watchers), play(none));
  for (Watcher& watcher : watchers) {
    EXPECT_FALSE(watcher.keeper->store().all().empty());
    EXPECT_GT(watcher.ghosts, 100U);
    EXPECT_TRUE(watcher.keeper->takeFaults().empty());
    for (const StoredRun& run : watcher.keeper->store().all()) {
      const auto track = trackOf(*replayOf(readBytes(run.file)));
      ASSERT_TRUE(track);
      EXPECT_EQ(track->ticks, run.ticks);
    }
  }
}

}  // namespace
}  // namespace platon::ghost_lockstep_test
