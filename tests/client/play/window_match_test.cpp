#include <algorithm>
#include <csignal>
#include <filesystem>
#include <string>
#include <string_view>

#include "client/play/match/embedded_server.h"
#include "client/play/match/match_play.h"
#include "tests/client/play/window_play_fixture.h"
#include "tests/support/process.h"

// The ways from the title to a match, by keys and mouse in a real window.
namespace platon {
namespace {

constexpr const char* kLevel = "tests/determinism/golden/levels/hexahedron.level";

class WindowMatchTest : public WindowPlayTest {
 protected:
  WindowMatchTest() { options_.level.clear(); }

  std::string levelTitle() const {
    const auto level = play_->match() ? play_->match()->play().level() : nullptr;
    return level ? level->title : "";
  }
  // The face of the own ball; nothing before the first round.
  std::optional<std::uint32_t> face() const {
    if (!isOnGround()) return std::nullopt;
    const Prediction& prediction = play_->match()->play().client().session()->round()->prediction();
    return prediction.predicted().world().entities()[prediction.slot()].part;
  }
  const Round* round() const { return isOnGround() ? play_->match()->play().client().session()->round() : nullptr; }
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
  static bool hears(const MatchPlay& play, std::string_view end) {
    const std::vector<std::string> chat = play.hudStatus(steadyClock().now(), false).chat;
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

TEST_F(WindowMatchTest, AServerThatStopsLeadsToTheOneThatItNames) {
  const EmbeddedServer other({{kLevel}});
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
        {[&] { clickOn("Join " + next); }, [&] { return inGame() && isOnGround() && other.players() == 1; }}});
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

TEST_F(WindowMatchTest, AServerIsJoinedByItsAddressAndPlayersTalk) {
  const EmbeddedServer server({{kLevel}});
  const std::string address = "127.0.0.1:" + std::to_string(server.address().port);
  ClientOptions named;
  named.name = "Grace";
  MatchPlay grace(named, server.address(), steadyClock().now());
  const auto meanwhile = [&](bool done) {
    grace.update(steadyClock().now(), [](const Game&, std::uint32_t) { return Input{}; });
    return done;
  };
  play({{[] {}, [&] { return meanwhile(shows("Join a server") && server.players() == 1); }},
        {[this] { clickOn("Join a server"); }, [&] { return meanwhile(shows("Address")); }},
        {[&] { xdotool("type " + address); }, [&] { return meanwhile(true); }},
        {[this] { clickOn("Join"); }, [&] { return meanwhile(server.players() == 2 && isOnGround() && inGame()); }},
        {[] { xdotool("key t"); }, [&] { return meanwhile(shows("Say")); }},
        {[] { xdotool("type hello"); }, [&] { return meanwhile(true); }},
        {[] { xdotool("key Return"); }, [&] { return meanwhile(hears(grace, ": hello") && inGame()); }},
        {[] { xdotool("key t"); }, [&] { return meanwhile(shows("Wave")); }},
        {[this] { clickOn("Wave"); }, [&] { return meanwhile(hears(grace, " waves")); }},
        {[&] {
           EXPECT_TRUE(grace.say({"well done", 0}, steadyClock().now()));
         },
         [&] { return meanwhile(hears(play_->match()->play(), "Grace: well done")); }},
        {[] { xdotool("key t"); }, [&] { return meanwhile(notes("Grace: well done")); }},
        {[] { xdotool("key Escape"); }, [&] { return meanwhile(inGame()); }},
        {[] { xdotool("key Escape"); }, [&] { return meanwhile(shows("Leave to the title")); }},
        {[this] { clickOn("Leave to the title"); },
         [&] { return meanwhile(play_->match() == nullptr && server.players() == 1); }}});
  EXPECT_TRUE(stepsDone_);
}

TEST_F(WindowMatchTest, ARecordingIsRacedAndAPictureIsKept) {
  const EnvironmentVariable pictures{"XDG_PICTURES_DIR", (folder_ / "pictures").string()};
  keepRecording("Anna.recording", "tests/levels/ways/01_run_and_jump.recording");
  bool quits = false;
  play({{[] {}, [this] { return shows("Replays"); }},
        {[this] { clickOn("Replays"); }, [this] { return shows("Run and jump"); }},
        {[this] { clickOn("Run and jump"); }, [this] { return shows("Race against it"); }},
        {[this] { clickOn("Race against it"); }, [this] { return inGame() && isOnGround() == std::optional(true); }},
        {[] { xdotool("key F12"); }, [this] { return std::filesystem::exists(folder_ / "pictures"); }},
        {[] {}, [this] { return !std::filesystem::is_empty(folder_ / "pictures"); }},
        {[] { xdotool("key Escape"); }, [this] { return shows("Leave to the title"); }},
        {[this] { clickOn("Leave to the title"); }, [this] { return shows("Quit"); }},
        {[&] {
           quits = true;
           clickOn("Quit");
         },
         [] { return false; }}});
  EXPECT_TRUE(quits);
  EXPECT_FALSE(timeIsUp_);
}

}  // namespace
}  // namespace platon
