#include <algorithm>
#include <csignal>
#include <filesystem>
#include <string>
#include <string_view>

#include "client/play/match/embedded_server.h"
#include "client/play/match/live_match.h"
#include "client/replay/replay.h"
#include "client/replay/run_list.h"
#include "client/replay/run_store.h"
#include "tests/client/play/match/on_loopback.h"
#include "tests/client/play/window_play_fixture.h"
#include "tests/support/process.h"

// The ways from the title to a match, by keys and mouse in a real window.
namespace platon::window_match_test {
namespace {

constexpr const char* kLevel = "tests/determinism/golden/levels/hexahedron.level";
constexpr const char* kRunLevel = "levels/data/hexahedron/01_run_and_jump.level";
constexpr const char* kRun = "levels/data/ways/01_run_and_jump.recording";

class WindowMatchTest : public WindowPlayTest {
 protected:
  WindowMatchTest() { options_.level.clear(); }

  std::string levelTitle() const {
    const auto level = match() ? match()->level() : nullptr;
    return level ? level->title : "";
  }
  // The face of the own ball; nothing before the first round.
  std::optional<std::uint32_t> face() const {
    if (!isOnGround()) return std::nullopt;
    const Prediction& prediction = match()->client().session()->round()->prediction();
    return prediction.predicted().world().entities()[prediction.slot()].part;
  }
  const Round* round() const { return isOnGround() ? match()->client().session()->round() : nullptr; }
  // Where the own ball is on its face; nothing before the first round.
  std::optional<Point> place() const {
    if (round() == nullptr) return std::nullopt;
    const Prediction& prediction = round()->prediction();
    return prediction.predicted().world().entities()[prediction.slot()].position;
  }
  // Ticks that the timer shows; nothing before the first round.
  std::optional<std::uint32_t> timer() const {
    return round() == nullptr ? std::nullopt : std::optional(round()->attemptTime().ticks());
  }
  // Makes kRun the best run on kRunLevel.
  void keepBestRun() const {
    const std::uint64_t level = readRecordingHeadOf(kRun).value().level->hash;
    const std::filesystem::path runs = folder_ / "platon/runs";
    std::filesystem::create_directories(runs);
    writeText(runs / RunStore::fileNameOf(level, readRecordingFacts(kRun).ticks.value()), readText(kRun));
  }
  static bool hears(const LiveMatch& match, std::string_view end) {
    const std::vector<std::string> chat = match.hudStatus().chat;
    return std::any_of(chat.begin(), chat.end(), [&](const std::string& line) { return line.ends_with(end); });
  }
};

TEST_F(WindowMatchTest, ALevelOfTheListIsPlayedOverAnEdge) {
  play({{[] {}, [this] { return shows("Levels"); }},
        {[this] { clickOn("Levels"); }, [this] { return shows("Run and jump"); }},
        {[this] { clickOn("Over the edge"); }, [this] { return levelTitle() == "Over the edge" && inGame(); }},
        {[] {}, [this] { return face() == 0U && isOnGround() == std::optional(true); }},
        {[] { xdotool("keydown Right"); }, [this] { return isOnGround() == std::optional(false); }},
        {[] { xdotool("keyup Right"); }, [this] { return isOnGround() == std::optional(true); }},
        {[] { xdotool("keydown Left"); }, [this] { return face() == 5U; }},
        {[] { xdotool("keyup Left"); }, [] { return true; }}});
  EXPECT_TRUE(stepsDone_);
}

// Before, "Ghost floor" began without a word.
TEST_F(WindowMatchTest, ALevelForTwoOfTheListIsHostedAndBeginsAnewWithTheGuest) {
  const std::string port = std::to_string(EmbeddedServer(onLoopback({kLevel})).address().port);  // that is free
  std::optional<LiveMatch> guest;
  const auto guested = [&](bool done) {
    guest->update(false, [](const Game&, std::uint32_t) { return Input{}; });
    return done;
  };
  const auto isSelected = [this](const std::string& name) {
    for (const MenuRow& row : menu().layout(font_).rows) {
      if (row.item == menu().focus()) return row.name.text == name;
    }
    return false;
  };
  play({{[] {}, [this] { return shows("Levels"); }},
        {[this] { clickOn("Levels"); }, [this] { return shows("Run and jump"); }},
        {[] { xdotool("key Up Up Up Up Up Up"); }, [&] { return isSelected("Hold the door"); }},
        {[] { xdotool("key Return"); }, [this] { return notes("This level needs 2 players") && shows("Join"); }},
        {[] { xdotool("key Down Return"); }, [this] { return shows("First level"); }},
        {[] { xdotool("key Up Up BackSpace BackSpace BackSpace BackSpace"); }, [] { return true; }},
        {[&] { xdotool("type " + port); }, [] { return true; }},
        {[] { xdotool("key Down Down Return"); }, [this] { return inGame() && levelTitle() == "Hold the door"; }},
        {[] {}, [this] { return round() != nullptr && round()->id() == 1; }},
        {[&] { guest.emplace(ClientOptions(), MatchChoice{.server = match()->serverAddress()}, steadyClock()); },
         [&] { return guested(round() != nullptr && round()->id() == 2 && !match()->alone()); }},
        {[&] {
           EXPECT_EQ(levelTitle(), "Hold the door");
           guest->leave();
         },
         [this] { return match()->alone(); }},
        {[] { xdotool("key v"); }, [this] { return levelTitle() == "Ghost floor"; }}});
  EXPECT_TRUE(stepsDone_);
}

TEST_F(WindowMatchTest, AServerThatStopsLeadsToTheOneThatItNames) {
  const EmbeddedServer other(onLoopback({kLevel}));
  const std::string next = "127.0.0.1:" + std::to_string(other.address().port);
  Process server(platonCommand("platon-server",
                               {kLevel, "--bind", "127.0.0.1", "--port", "0", "--drain", "600", "--drain-to", next}));
  options_.server = parseServerAddress(server.waitForError("listening on "));
  const auto stop = [&] {
    server.signal(SIGTERM);
    server.waitForError("draining seconds=600");
    server.signal(SIGTERM);
  };
  play({{[] {}, [this] { return inGame() && isOnGround(); }},
        {stop, [&] { return shows("Join " + next); }},
        {[&] { clickOn("Join " + next); }, [&] { return inGame() && isOnGround() && other.clients() == 1; }}});
  EXPECT_TRUE(stepsDone_);
  EXPECT_EQ(server.wait(), 0);
}

TEST_F(WindowMatchTest, RPutsTheBallBackToTheStartAndTheTimerToZero) {
  options_.level = kLevel;
  std::optional<Point> start;
  play({{[] {}, [this] { return inGame() && isOnGround() == std::optional(true) && timer() == 0U; }},
        {[&] {
           start = place();
           xdotool("keydown Right");
         },
         [&] { return place() != start && timer() > 30U; }},
        {[] { xdotool("keyup Right"); }, [&] { return place() != start; }},
        {[] { xdotool("key r"); }, [&] { return place() == start && timer() == 0U; }}});
  EXPECT_TRUE(stepsDone_);
}

// The first tick from `first` on in which the player presses a button; replay.ticks() if there is none.
std::uint32_t tickWith(const Replay& replay, std::uint8_t button, std::uint32_t first) {
  std::uint32_t tick = first;
  const auto presses = [&] { return !replay.inputsOf(tick).empty() && replay.inputsOf(tick)[0].has(button); };
  while (tick < replay.ticks() && !presses()) ++tick;
  return tick;
}

// A replay before the match; in it a menu, a best run and a ghost of a friend, and a restart.
TEST_F(WindowMatchTest, TheRecordingOfTheServerIsTheMatchWithMenusReplaysAndGhosts) {
  const std::uint32_t runTicks = readRecordingFacts(kRun).ticks.value();
  keepRecording("Anna.recording", kRun);
  keepBestRun();
  Process server(
      platonCommand("platon-server", {kRunLevel, "--bind", "127.0.0.1", "--port", "0", "--record", folder_ / "games"}));
  const std::string address = server.waitForError("listening on ");
  const auto confirmed = [&] { return round() == nullptr ? 0 : round()->prediction().confirmedTicks(); };
  std::uint32_t before = 0;
  std::uint64_t hash = 0;
  play({{[] {}, [this] { return shows("Replays"); }},
        {[this] { clickOn("Replays"); }, [this] { return shows("Run and jump"); }},
        {[this] { clickOn("Run and jump"); }, [this] { return shows("Watch"); }},
        {[this] { clickOn("Watch"); }, [this] { return viewer() != nullptr && player().tick() > 10; }},
        {[] { xdotool("key Escape"); }, [this] { return replay() == nullptr && shows("Watch"); }},
        {[] { xdotool("key Escape Escape"); }, [this] { return shows("Join a server"); }},
        {[this] { clickOn("Join a server"); }, [this] { return shows("Address"); }},
        {[&] { xdotool("type " + address); }, [] { return true; }},
        {[this] { clickOn("Join"); }, [this] { return inGame() && isOnGround() == std::optional(true); }},
        {[] { xdotool("keydown Right"); }, [this] { return timer() > 60U; }},
        {[] { xdotool("keyup Right"); }, [] { return true; }},
        {[&] {
           EXPECT_EQ(match()->hudStatus().run.best, double{1} * runTicks / kTicksPerSecond);
           before = confirmed();
           xdotool("key Escape");
         },
         [&] { return shows("Return to the title") && confirmed() > before + 60; }},
        {[] { xdotool("key Escape"); }, [this] { return inGame(); }},
        {[] { xdotool("key r"); }, [this] { return timer() == 0U; }},
        {[] { xdotool("keydown Right"); }, [this] { return timer() > 30U; }},
        {[] { xdotool("keyup Right"); }, [&] { return confirmed() > 8 * kTicksPerSecond; }},
        {[] { xdotool("key Escape"); }, [this] { return shows("Return to the title"); }},
        {[&] {
           EXPECT_EQ(round()->statistics().desyncs, 0U);
           before = confirmed();
           hash = round()->prediction().confirmed().hash();
           clickOn("Return to the title");
         },
         [this] { return match() == nullptr; }}});
  ASSERT_TRUE(stepsDone_);
  server.signal(SIGTERM);
  EXPECT_EQ(server.wait(), 0);
  std::vector<std::filesystem::path> games;
  for (const auto& entry : std::filesystem::directory_iterator(folder_ / "games")) games.push_back(entry.path());
  ASSERT_EQ(games.size(), 1U);
  const auto read = readReplay(games[0]);
  ASSERT_EQ(read.index(), 0U) << std::get<std::string>(read);
  const Replay& replay = *std::get<0>(read);
  const std::uint32_t restart = tickWith(replay, Input::kRestart, 0);
  EXPECT_LT(tickWith(replay, Input::kRight, 0), restart);
  EXPECT_LT(tickWith(replay, Input::kRight, restart), replay.ticks()) << "the game goes on after the restart";
  ASSERT_LE(before, replay.ticks());
  EXPECT_EQ(replay.gameAfter(before).tick(), before);
  EXPECT_EQ(replay.gameAfter(before).hash(), hash);
}

TEST_F(WindowMatchTest, AServerIsJoinedByItsAddressAndPlayersTalk) {
  const EmbeddedServer server(onLoopback({kLevel}));
  const std::string address = "127.0.0.1:" + std::to_string(server.address().port);
  ClientOptions named;
  named.name = "Grace";
  std::optional<LiveMatch> grace;
  const auto meanwhile = [&](bool done) {
    grace->update(false, [](const Game&, std::uint32_t) { return Input{}; });
    return done;
  };
  // Joins when the window is open: until then nobody would update her, and her server might give her up.
  play({{[&] { grace.emplace(named, MatchChoice{.server = server.address()}, steadyClock()); },
         [&] { return meanwhile(shows("Join a server") && server.clients() == 1); }},
        {[this] { clickOn("Join a server"); }, [&] { return meanwhile(shows("Address")); }},
        {[&] { xdotool("type " + address); }, [&] { return meanwhile(true); }},
        {[this] { clickOn("Join"); }, [&] { return meanwhile(server.clients() == 2 && isOnGround() && inGame()); }},
        {[] { xdotool("key t"); }, [&] { return meanwhile(shows("Send")); }},
        {[] { xdotool("type hello"); }, [&] { return meanwhile(true); }},
        {[] { xdotool("key Return"); }, [&] { return meanwhile(hears(*grace, ": hello") && inGame()); }},
        {[] { xdotool("key t"); }, [&] { return meanwhile(shows("Wave")); }},
        {[this] { clickOn("Wave"); }, [&] { return meanwhile(hears(*grace, " waves")); }},
        {[&] {
           EXPECT_TRUE(grace->say({"well done", 0}));
         },
         [&] { return meanwhile(hears(*match(), "Grace: well done")); }},
        {[] { xdotool("key t"); }, [&] { return meanwhile(notes("Grace: well done")); }},
        {[] { xdotool("key Escape"); }, [&] { return meanwhile(inGame()); }},
        {[] { xdotool("key Escape"); }, [&] { return meanwhile(shows("Return to the title")); }},
        {[this] { clickOn("Return to the title"); },
         [&] { return meanwhile(match() == nullptr && server.clients() == 1); }}});
  EXPECT_TRUE(stepsDone_);
}

TEST_F(WindowMatchTest, WhoJoinsEndsTheReplayInFrontOfTheGame) {
  keepBestRun();
  const std::string port = std::to_string(EmbeddedServer(onLoopback({kLevel})).address().port);  // that is free
  std::optional<LiveMatch> grace;
  const auto join = [&] {
    grace.emplace(ClientOptions(), MatchChoice{.server = match()->serverAddress()}, steadyClock());
  };
  const auto update = [&] { grace->update(false, [](const Game&, std::uint32_t) { return Input{}; }); };
  play({{[] {}, [this] { return shows("Host a game"); }},
        {[this] { clickOn("Host a game"); }, [this] { return shows("First level"); }},
        {[this] { clickOn("Port"); }, [] { return true; }},
        {[] { xdotool("key BackSpace BackSpace BackSpace BackSpace"); }, [] { return true; }},
        {[&] { xdotool("type " + port); }, [] { return true; }},
        {[this] { clickOn("Start"); }, [this] { return inGame() && isOnGround() == std::optional(true); }},
        {[] { xdotool("key Escape"); }, [this] { return shows("Watch your best run"); }},
        {[this] { clickOn("Watch your best run"); }, [this] { return viewer() != nullptr && player().tick() > 10; }},
        {join,
         [&] {
           update();
           return !match()->alone() && replay() == nullptr && shows("Return to the title");
         }},
        {[] {}, [this] { return !shows("Watch your best run") && !match()->paused(); }}});
  EXPECT_TRUE(stepsDone_);
}

TEST_F(WindowMatchTest, ARecordingIsRacedAndAPictureIsKept) {
  const EnvironmentVariable pictures{"XDG_PICTURES_DIR", (folder_ / "pictures").string()};
  keepRecording("Anna.recording", "levels/data/ways/01_run_and_jump.recording");
  bool quits = false;
  play({{[] {}, [this] { return shows("Replays"); }},
        {[this] { clickOn("Replays"); }, [this] { return shows("Run and jump"); }},
        {[this] { clickOn("Run and jump"); }, [this] { return shows("Race against it"); }},
        {[this] { clickOn("Race against it"); }, [this] { return inGame() && isOnGround() == std::optional(true); }},
        {[] { xdotool("key F12"); }, [this] { return std::filesystem::exists(folder_ / "pictures"); }},
        {[] {}, [this] { return !std::filesystem::is_empty(folder_ / "pictures"); }},
        {[] { xdotool("key Escape"); }, [this] { return shows("Return to the title"); }},
        {[this] { clickOn("Return to the title"); }, [this] { return shows("Quit"); }},
        {[&] {
           quits = true;
           clickOn("Quit");
         },
         [] { return false; }}});
  EXPECT_TRUE(quits);
  EXPECT_FALSE(timeIsUp_);
}

}  // namespace
}  // namespace platon::window_match_test
