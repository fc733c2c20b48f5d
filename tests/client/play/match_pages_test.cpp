#include "client/play/match_pages.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "client/files/user_folders.h"
#include "client/replay/replay.h"
#include "client/replay/run_list.h"
#include "client/replay/run_store.h"
#include "client/time/steady_now.h"
#include "client/ui/font.h"
#include "tests/client/play/match/on_loopback.h"
#include "tests/support/environment_variable.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/wait_until.h"

namespace platon::match_pages_test {
namespace {

TEST(SkipQuestion, TheSecondWishLeavesAnUnfinishedLevel) {
  SkipQuestion question;
  EXPECT_FALSE(question.wish(false));
  EXPECT_TRUE(question.asked());
  EXPECT_TRUE(question.wish(false));
  EXPECT_FALSE(question.asked());
  EXPECT_FALSE(question.wish(false)) << "the next level is asked about anew";
}

TEST(SkipQuestion, AnythingElseTakesTheWishBack) {
  SkipQuestion question;
  question.wish(false);
  question.takeBack();
  EXPECT_FALSE(question.asked());
  EXPECT_FALSE(question.wish(false));
}

TEST(SkipQuestion, AfterTheGoalNothingIsAsked) {
  SkipQuestion question;
  EXPECT_TRUE(question.wish(true));
  EXPECT_FALSE(question.asked());
  question.wish(false);
  EXPECT_TRUE(question.wish(true)) << "the goal was reached meanwhile";
  EXPECT_FALSE(question.asked());
}

class MatchPagesTest : public testing::Test {
 protected:
  MatchPagesTest() {
    choice_.own = onLoopback({"tests/determinism/golden/levels/hexahedron.level"});
    match_.emplace(ClientOptions(), choice_, clock_);
    EXPECT_TRUE(waitUntil([this] {
      match_->update(false, [](const Game&, std::uint32_t) { return Input{}; });
      return match_->level() != nullptr;
    }));
  }
  ~MatchPagesTest() override { match_->leave(); }

  bool shows(const std::string& text) const {
    for (const Overlay::Text& each : menu_.overlay(font_, false).texts) {
      if (each.content.find(text) != std::string::npos) return true;
    }
    return false;
  }
  void tap(Key key) { menu_.handle({key, KeyEvent::Kind::kPress}, font_); }

  const TemporaryFolder folder_;
  const EnvironmentVariable data_{"XDG_DATA_HOME", folder_.path().string()};
  const Clock clock_ = steadyClock();
  const Font font_;
  Menu menu_;
  UserInterface interface_{Settings()};
  MatchChoice choice_;
  std::optional<LiveMatch> match_;
  std::vector<std::string> called_;
  MatchPages pages_{menu_,
                    interface_,
                    {[this] { called_.emplace_back("settings"); }, [this] { called_.emplace_back("leave"); },
                     [this](const std::filesystem::path&) { called_.emplace_back("watch"); },
                     [this](const std::string& text) { called_.push_back(text); }}};
};

TEST_F(MatchPagesTest, ThePauseOfAPlayerWhoIsAloneLeadsToTheNextLevel) {
  pages_.showPause(*match_);
  EXPECT_TRUE(shows("Pause"));
  EXPECT_TRUE(shows("Next level"));
  EXPECT_FALSE(shows("The game goes on"));
  EXPECT_FALSE(shows("Watch")) << "there is no run";
  EXPECT_FALSE(shows("Talk")) << "nobody would hear it";
}

// Before, it skipped the level at once, while V asks.
TEST_F(MatchPagesTest, ThePauseAsksBeforeItSkipsALevelWhoseGoalIsNotReached) {
  const auto round = [this] { return match_->client().session()->round()->id(); };
  const std::uint32_t first = round();
  pages_.showPause(*match_);
  menu_.setFocus(2);
  tap(Key::kEnter);
  EXPECT_TRUE(shows("Skip this level?"));
  pages_.showPause(*match_);
  EXPECT_FALSE(shows("Skip this level?")) << "whoever opens it again is asked again";
  menu_.setFocus(2);
  tap(Key::kEnter);
  EXPECT_TRUE(menu_.isOpen());
  tap(Key::kEnter);
  EXPECT_FALSE(menu_.isOpen());
  EXPECT_TRUE(waitUntil([&] {
    match_->update(false, [](const Game&, std::uint32_t) { return Input{}; });
    return round() == first + 1;
  }));
}

TEST_F(MatchPagesTest, ThePauseLeadsToTheSettingsAndOut) {
  pages_.showPause(*match_);
  tap(Key::kArrowUp);  // to the last item
  tap(Key::kEnter);
  tap(Key::kArrowUp);
  tap(Key::kEnter);
  EXPECT_EQ(called_, (std::vector<std::string>{"leave", "settings"}));
  tap(Key::kEscape);
  EXPECT_FALSE(menu_.isOpen());
}

TEST_F(MatchPagesTest, AGamepadThatIsUnpluggedShowsThePauseToWhoIsAlone) {
  pages_.loseGamepad(*match_);
  EXPECT_TRUE(shows("Pause"));
  EXPECT_TRUE(shows("Gamepad disconnected"));
  EXPECT_TRUE(called_.empty());
  tap(Key::kEscape);
  pages_.showPause(*match_);
  EXPECT_FALSE(shows("Gamepad disconnected"));
  pages_.loseGamepad(*match_);
  EXPECT_EQ(called_, (std::vector<std::string>{"Gamepad disconnected"})) << "an open page stays";
  EXPECT_FALSE(shows("Gamepad disconnected"));
}

TEST_F(MatchPagesTest, WithOthersAGamepadThatIsUnpluggedStopsNoGameAndThePauseLeadsToTalk) {
  MatchChoice guest;
  guest.server = match_->serverAddress();
  LiveMatch other(ClientOptions(), guest, clock_);
  const auto idle = [](const Game&, std::uint32_t) { return Input{}; };
  ASSERT_TRUE(waitUntil([&] {
    other.update(false, idle);
    match_->update(false, idle);
    return !match_->alone();
  }));
  for (LiveMatch* const match : {&*match_, &other}) pages_.loseGamepad(*match);
  EXPECT_FALSE(menu_.isOpen());
  EXPECT_EQ(called_, std::vector<std::string>(2, "Gamepad disconnected"));
  pages_.showPause(*match_);
  for (int row = 0; row < 3; ++row) tap(Key::kPadDown);
  tap(Key::kPadA);
  EXPECT_TRUE(shows("Talk to all players"));
  other.leave();
}

TEST_F(MatchPagesTest, TheBestRunIsOfferedAsLongAsThePlayerIsAlone) {
  const std::filesystem::path recording = "levels/data/ways/01_run_and_jump.recording";
  const std::uint64_t level = readRecordingHeadOf(recording).value().level->hash;
  const std::string name = RunStore::fileNameOf(level, readRecordingFacts(recording).ticks.value());
  std::filesystem::create_directories(runsFolder());
  writeText(runsFolder() / name, readText(recording));
  const auto idle = [](const Game&, std::uint32_t) { return Input{}; };
  choice_.own.levels = {"levels/data/hexahedron/01_run_and_jump.level"};
  match_->leave();
  match_.emplace(ClientOptions(), choice_, clock_);
  ASSERT_TRUE(waitUntil([&] {
    match_->update(false, idle);
    return match_->level() != nullptr;
  }));
  EXPECT_EQ(match_->bestRun(), runsFolder() / name);
  pages_.showPause(*match_);
  EXPECT_TRUE(shows("Watch"));
  MatchChoice guest;
  guest.server = match_->serverAddress();
  LiveMatch other(ClientOptions(), guest, clock_);
  ASSERT_TRUE(waitUntil([&] {
    other.update(false, idle);
    match_->update(false, idle);
    return !match_->alone();
  }));
  EXPECT_FALSE(shows("Watch"));
  other.leave();
}

TEST_F(MatchPagesTest, WhoSaysTooMuchAtOnceIsTold) {
  for (int times = 0; times < 100 && called_.empty(); ++times) {
    pages_.showSay(*match_);
    menu_.setFocus(2);  // an emote, below the text and its button
    tap(Key::kEnter);
    EXPECT_FALSE(menu_.isOpen());
  }
  EXPECT_EQ(called_, (std::vector<std::string>{"too much at once: wait a moment"}));
}

}  // namespace
}  // namespace platon::match_pages_test
