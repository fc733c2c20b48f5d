#include "client/play/match/live_match.h"

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <string_view>

#include <gtest/gtest.h>

#include "client/files/user_folders.h"
#include "client/time/steady_now.h"
#include "server/app/dedicated_server.h"
#include "server/app/level_files.h"
#include "tests/support/environment_variable.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/wait_until.h"

namespace platon::live_match_test {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr const char* kLevel = "tests/determinism/golden/levels/hexahedron.level";

// The same for a tick of the same number.
Input inputOf(std::uint32_t tick) { return Input{tick / 20 % 2 == 0 ? Input::kRight : Input::kLeft}; }

class LiveMatchTest : public testing::Test {
 protected:
  static MatchChoice ownLevel() {
    MatchChoice choice;
    choice.own.levels = {kLevel};
    return choice;
  }

  bool updateUntil(LiveMatch& match, bool wantsPause, const std::function<bool()>& done) {
    const Controls controls = [](const Game& game, std::uint32_t) { return inputOf(game.tick()); };
    const Moment end = clock_.now() + seconds(60);
    for (Moment now = clock_.now(); now < end; now = clock_.now()) {
      match.update(wantsPause, controls);
      if (done()) return true;
      clock_.sleepUntil(now + milliseconds(2));
    }
    return false;
  }

  // Lets a match pause for 7 s, of which less than one is real.
  void passLongerThanEveryTimeout(LiveMatch& match) {
    int frames = 0;
    stepUntil(
        [&] {
          skipped_ += milliseconds(20) / Moment(1);
          match.update(true, [](const Game&, std::uint32_t) { return Input{}; });
        },
        [&] { return ++frames == 350; });
  }

  static const Prediction* prediction(const LiveMatch& match) {
    const Session* const session = match.play().client().session();
    return session && session->round() ? &session->round()->prediction() : nullptr;
  }
  static std::uint32_t confirmed(const LiveMatch& match) {
    return prediction(match) ? prediction(match)->confirmedTicks() : 0;
  }

  const TemporaryFolder folder_;
  const EnvironmentVariable data_{"XDG_DATA_HOME", folder_.path().string()};
  std::atomic<Moment::rep> skipped_ = 0;
  // Real time, and what was skipped.
  const Clock clock_{[this] { return steadyClock().now() + Moment(skipped_); },
                     [this](Moment until) { steadyClock().sleepUntil(until - Moment(skipped_)); }};
};

TEST_F(LiveMatchTest, NoTickPassesWhileAPlayerWhoIsAlonePauses) {
  LiveMatch match(ClientOptions(), ownLevel(), clock_);
  ASSERT_TRUE(updateUntil(match, false, [&] { return confirmed(match) > 30 && match.alone(); }));
  ASSERT_TRUE(updateUntil(match, true, [&] { return match.paused(); }));
  passLongerThanEveryTimeout(match);  // until nothing is on the way any more
  const std::uint32_t before = confirmed(match);
  const std::uint32_t predicted = prediction(match)->predictedTicks();
  passLongerThanEveryTimeout(match);
  EXPECT_EQ(confirmed(match), before);
  EXPECT_EQ(prediction(match)->predictedTicks(), predicted);
  EXPECT_TRUE(updateUntil(match, false, [&] { return confirmed(match) > before + 30; }));
  EXPECT_EQ(match.play().message(), "");
  match.leave();
}

TEST_F(LiveMatchTest, WithAnotherPlayerTheGameGoesOn) {
  LiveMatch match(ClientOptions(), ownLevel(), clock_);
  ASSERT_TRUE(updateUntil(match, false, [&] { return confirmed(match) > 10; }));
  MatchChoice guest;
  guest.server = match.serverAddress();
  LiveMatch other(ClientOptions(), guest, clock_);
  ASSERT_TRUE(updateUntil(match, true, [&] {
    other.update(true, [](const Game&, std::uint32_t) { return Input{}; });
    return confirmed(other) > 10;
  }));
  EXPECT_FALSE(match.alone());
  EXPECT_FALSE(match.paused());
  EXPECT_FALSE(other.paused());
  other.leave();
  EXPECT_TRUE(updateUntil(match, true, [&] { return match.paused(); }));
  match.leave();
}

TEST_F(LiveMatchTest, ARoundOfAPlayerWhoIsAloneHasNoTimeLimit) {
  MatchChoice choice = ownLevel();
  choice.own.waitsForOne = true;
  LiveMatch match(ClientOptions(), choice, clock_);
  ASSERT_TRUE(updateUntil(match, false, [&] { return confirmed(match) > 10 && match.waits(); }));
  match.update(false, [](const Game&, std::uint32_t) { return Input{}; });
  EXPECT_FALSE(match.play().scene(match.now())->timed);
  MatchChoice guest;
  guest.server = match.serverAddress();
  LiveMatch other(ClientOptions(), guest, clock_);
  ASSERT_TRUE(updateUntil(match, false, [&] {
    other.update(false, [](const Game&, std::uint32_t) { return Input{}; });
    return confirmed(other) > 10 && !match.alone();
  }));
  EXPECT_FALSE(match.waits());
  match.update(false, [](const Game&, std::uint32_t) { return Input{}; });
  EXPECT_TRUE(match.play().scene(match.now())->timed);
  EXPECT_TRUE(other.play().scene(other.now())->timed);
  other.leave();
  match.leave();
}

TEST_F(LiveMatchTest, AskingTwiceForTheNextLevelSkipsNone) {
  LiveMatch match(ClientOptions(), ownLevel(), clock_);
  ASSERT_TRUE(updateUntil(match, false, [&] { return confirmed(match) > 10 && match.alone(); }));
  const auto round = [&] { return match.play().client().session()->round()->id(); };
  const std::uint32_t first = round();
  match.skipLevel();
  ASSERT_TRUE(updateUntil(match, false, [&] {
    if (round() == first) match.skipLevel();
    return round() != first && confirmed(match) > 10;
  }));
  EXPECT_EQ(round(), first + 1);
  match.leave();
}

TEST_F(LiveMatchTest, RunsSlowerForWhoIsAloneOnly) {
  LiveMatch match(ClientOptions(), ownLevel(), clock_);
  ASSERT_TRUE(updateUntil(match, false, [&] { return confirmed(match) > 10 && match.alone(); }));
  EXPECT_EQ(match.leastSpeed(), 1);
  match.setSpeed(0.5);
  ASSERT_TRUE(updateUntil(match, false, [&] { return match.leastSpeed() == 0.5; }));
  const Moment real = clock_.now();
  const Moment own = match.now();
  ASSERT_TRUE(updateUntil(match, false, [&] { return match.now() - own > milliseconds(100); }));
  EXPECT_GE(clock_.now() - real, milliseconds(200));
  match.setSpeed(1);
  ASSERT_TRUE(updateUntil(match, false, [&] { return confirmed(match) > 30; }));
  EXPECT_EQ(match.leastSpeed(), 0.5) << "of this attempt";
  match.setSpeed(0.5);
  MatchChoice guest;
  guest.server = match.serverAddress();
  LiveMatch other(ClientOptions(), guest, clock_);
  other.setSpeed(0.5);
  ASSERT_TRUE(updateUntil(match, false, [&] {
    other.update(false, [](const Game&, std::uint32_t) { return Input{}; });
    return confirmed(other) > 10 && !match.alone();
  }));
  EXPECT_EQ(other.leastSpeed(), 1);
  const Moment time = match.now();
  const Moment before = clock_.now();
  updateUntil(match, false, [&] { return clock_.now() - before > milliseconds(50); });
  EXPECT_GE(match.now() - time, milliseconds(50)) << "not slowed with others";
  other.leave();
  match.leave();
}

// A floor on which a player that runs to the right reaches the goal within two seconds.
constexpr const char* kShortWay =
    "HEXAHEDRON\n0 -100 -180 0\n0 0 -190\n480\n%\n-240 -200 240 -200\n-120 -200 -120 0\n%\n%\n%\n%\n%\n";

TEST_F(LiveMatchTest, AGoalReachedAtHalfSpeedIsRememberedWithoutATime) {
  const std::string file = folder_ / "short.level";
  writeText(file, kShortWay);
  MatchChoice choice;
  choice.own.levels = {file};
  choice.own.waitsForOne = true;
  LiveMatch match(ClientOptions(), choice, clock_);
  const auto run = [&](Input input, const std::function<bool()>& done) {
    return waitUntil([&] {
      match.update(false, [&](const Game&, std::uint32_t) { return input; });
      return done();
    });
  };
  const auto arrived = [&] {
    const Prediction* const known = prediction(match);
    return known && known->confirmed().slots() > 0 && known->confirmed().player(0).arrived != 0;
  };
  match.setSpeed(0.5);
  ASSERT_TRUE(run(Input{Input::kRight}, arrived));
  EXPECT_EQ(match.leastSpeed(), 0.5);
  EXPECT_TRUE(ReachedLevels(reachedLevelsFile()).has(match.play().level()->hash));
  EXPECT_FALSE(match.play().hudStatus(match.now(), false).run.isNewBest);
  match.setSpeed(1);
  ASSERT_TRUE(run(Input{Input::kRestart}, [&] { return !arrived(); }));
  ASSERT_TRUE(run(Input{Input::kRight}, arrived));
  EXPECT_EQ(match.leastSpeed(), 1) << "an attempt begun at full speed counts";
  EXPECT_TRUE(match.play().hudStatus(match.now(), false).run.isNewBest);
  match.leave();
}

TEST_F(LiveMatchTest, OnlyAServerThatListensHasAnInvitation) {
  LiveMatch match(ClientOptions(), ownLevel(), clock_);
  EXPECT_TRUE(match.invitation().empty());
  MatchChoice hosted = ownLevel();
  hosted.own.listens = true;
  hosted.own.port = 0;
  hosted.own.password = "secret";
  LiveMatch open(ClientOptions(), hosted, clock_);
  ASSERT_EQ(open.invitation().size(), 1U);
  EXPECT_TRUE(updateUntil(open, false, [&] { return confirmed(open) > 10; })) << "its own player knows the password";
  open.leave();
}

// Hashes of the confirmed game by tick, of a client and a server that go by one clock. With `pauses`, the clock stands
// still for 3 s after every 0.7 s. Time is virtual.
std::map<std::uint32_t, std::uint64_t> hashesOf(bool pauses, double speed = 1) {
  Moment real = steadyClock().now();
  PausableClock clock([&real] { return real; });
  ServerSettings settings;
  settings.bind = "127.0.0.1";
  clock.setSpeed(speed);
  DedicatedServer server(settings, loadLevelFiles({kLevel}).levels, Log(LogFormat::kText, [](std::string_view) {}));
  NetworkClient client({"127.0.0.1", server.port()}, {"Ann"}, clock.now());
  std::map<std::uint32_t, std::uint64_t> hashes;
  for (int step = 0; hashes.empty() || hashes.rbegin()->first < 600; ++step) {
    clock.setPaused(pauses && step % 1850 >= 350);
    server.step(TimePoint(clock.now()));
    client.update(clock.now(), [](const Game& game, std::uint32_t) { return inputOf(game.tick()); });
    const Session* const session = client.session();
    if (session && session->round()) {
      const Prediction& prediction = session->round()->prediction();
      hashes.emplace(prediction.confirmedTicks(), prediction.confirmed().hash());
    }
    real += milliseconds(2);
  }
  return hashes;
}

TEST(PausedMatch, TheSameInputsAtHalfSpeedGiveTheSameHashes) { EXPECT_EQ(hashesOf(false, 0.5), hashesOf(false)); }

TEST(PausedMatch, TheSameInputsWithPausesGiveTheSameHashes) { EXPECT_EQ(hashesOf(true), hashesOf(false)); }

}  // namespace
}  // namespace platon::live_match_test
