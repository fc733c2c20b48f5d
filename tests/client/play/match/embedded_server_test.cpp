#include "client/play/match/embedded_server.h"

#include <chrono>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "client/net/enet_link.h"
#include "client/session/network_client.h"
#include "client/time/steady_now.h"
#include "protocol/program_error.h"
#include "tests/client/play/match/on_loopback.h"
#include "tests/support/environment_variable.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_levels.h"

namespace platon::embedded_server_test {
namespace {

constexpr const char* kLevel = "tests/determinism/golden/levels/hexahedron.level";

bool connects(const ServerAddress& address) {
  const Clock clock = steadyClock();
  NetworkClient client(enetLinks(address), {"someone"}, clock.now());
  const Time end = clock.now() + std::chrono::seconds(60);
  for (Time now = clock.now(); now < end && !client.welcomed() && !client.ending(); now = clock.now()) {
    client.update(now, [](const Game&, std::uint32_t) { return Input{}; });
    clock.sleepUntil(now + std::chrono::milliseconds(2));
  }
  return client.welcomed();
}

// The exit code and the message of the error.
std::pair<int, std::string> errorOf(const std::string& levelFile) {
  try {
    const EmbeddedServer server(onLoopback({levelFile}));
    return {0, ""};
  } catch (const ProgramError& error) {
    return {error.exitCode(), error.what()};
  }
}

TEST(EmbeddedServer, AcceptsAClientOnLoopback) {
  const EmbeddedServer server(onLoopback({kLevel}));
  EXPECT_EQ(server.address().host, "127.0.0.1");
  EXPECT_NE(server.address().port, 0);
  EXPECT_TRUE(connects(server.address()));
}

// Without a thread it answers only while it is stepped.
TEST(EmbeddedServer, AServerThatIsSteppedGoesByItsCallerAlone) {
  Time now = std::chrono::seconds(1000);
  const auto clock = std::make_shared<PausableClock>([&now] { return now; });
  EmbeddedSettings settings = onLoopback({kLevel});
  settings.stepped = true;
  EmbeddedServer server(settings, clock);
  NetworkClient client(enetLinks(server.address()), {"someone"}, now);
  const auto update = [&](int times, bool steps) {
    for (int i = 0; i < times; ++i) {
      now += std::chrono::microseconds(16'667);
      if (steps) server.step();
      client.update(now, [](const Game&, std::uint32_t) { return Input{}; });
    }
  };
  update(60, false);
  EXPECT_FALSE(client.welcomed());
  update(60, true);
  EXPECT_TRUE(client.welcomed());
  ASSERT_TRUE(client.session() != nullptr && client.session()->round() != nullptr);
  const std::uint32_t before = client.session()->round()->prediction().confirmedTicks();
  update(60, true);
  EXPECT_EQ(client.session()->round()->prediction().confirmedTicks() - before, 60U);
}

TEST(EmbeddedServer, WithoutALevelFileItPlaysTheShippedLevels) {
  const EmbeddedServer server(onLoopback({}));
  EXPECT_TRUE(connects(server.address()));
}

TEST(EmbeddedServer, EachServerHasAPortOfItsOwn) {
  const EmbeddedServer first(onLoopback({kLevel}));
  const EmbeddedServer second(onLoopback({kLevel}));
  EXPECT_NE(first.address().port, second.address().port);
}

// Before, the page to host a game named an option of the command line.
TEST(EmbeddedServer, APortThatIsTakenIsToldInTheWordsOfThePage) {
  const TemporaryFolder folder;
  const EnvironmentVariable data("XDG_DATA_HOME", folder.path().string());
  EmbeddedSettings settings = onLoopback({kLevel});
  const EmbeddedServer first(settings);
  settings.port = first.address().port;
  try {
    const EmbeddedServer second(settings);
    ADD_FAILURE();
  } catch (const ProgramError& error) {
    EXPECT_EQ(error.what(),
              "Another program uses UDP port " + std::to_string(settings.port) + ": choose another port.");
  }
}

TEST(EmbeddedServer, AMissingLevelFileIsAUsageError) {
  const auto [exitCode, message] = errorOf("levels/no_such.level");
  EXPECT_EQ(exitCode, ProgramError::kUsage);
  EXPECT_NE(message.find("levels/no_such.level"), std::string::npos) << message;
}

TEST(EmbeddedServer, AnInvalidLevelIsALevelError) {
  const TemporaryFolder folder;
  const std::string file = folder / "invalid.level";
  writeText(file, "CUBE\n");
  const auto [exitCode, message] = errorOf(file);
  EXPECT_EQ(exitCode, ProgramError::kInvalid);
  EXPECT_EQ(message.find(file + ":1:1: error: "), 0U) << message;
}

// A client that plays on the server.
class Guest {
 public:
  explicit Guest(const ServerAddress& address)
      : clock_(steadyClock()), client_(enetLinks(address), {"someone"}, clock_.now()) {}

  template <class Condition>
  bool playUntil(Condition&& condition) {
    const Time end = clock_.now() + std::chrono::seconds(60);
    for (Time now = clock_.now(); now < end; now = clock_.now()) {
      if (condition(client_)) return true;
      client_.update(now, [](const Game&, std::uint32_t) { return Input{}; });
      clock_.sleepUntil(now + std::chrono::milliseconds(2));
    }
    return false;
  }

 private:
  Clock clock_;
  NetworkClient client_;
};

TEST(EmbeddedServer, PlaysTheLevelAnewWhenItsFileChanges) {
  const TemporaryFolder folder;
  const std::string file = folder / "mine.level";
  const auto plays = [](const std::string& title) {
    return [title](const NetworkClient& client) {
      const Round* const round = client.session() ? client.session()->round() : nullptr;
      return round && round->prediction().predicted().level().title == title;
    };
  };
  writeText(file, "# title: first\n" + nearGoalText());
  const EmbeddedServer server(onLoopback({file}));
  Guest guest(server.address());
  ASSERT_TRUE(guest.playUntil(plays("first")));
  writeText(file, "# title: broken\nCUBE\n");
  ASSERT_TRUE(guest.playUntil([](NetworkClient& client) { return client.takeNotice().has_value(); }));
  writeText(file, "# title: second\n" + nearGoalText());
  EXPECT_TRUE(guest.playUntil(plays("second")));
}

// Before, who hosted a level for two played the one after it.
TEST(EmbeddedServer, PlaysTheChosenLevelAlsoIfItIsForTwo) {
  const TemporaryFolder folder;
  const std::vector<std::string> files{folder / "pair.level", folder / "alone.level"};
  writeText(files[0], "# title: pair\n# players: 2\n" + nearGoalText());
  writeText(files[1], "# title: alone\n" + nearGoalText());
  const EmbeddedServer server(onLoopback(files));
  Guest guest(server.address());
  std::string title;
  ASSERT_TRUE(guest.playUntil([&](const NetworkClient& client) {
    const Round* const round = client.session() ? client.session()->round() : nullptr;
    if (round != nullptr) title = round->prediction().predicted().level().title;
    return round != nullptr;
  }));
  EXPECT_EQ(title, "pair");
}

TEST(EmbeddedServer, CountsItsPlayersAndStartsTheNextLevelWhenAsked) {
  const TemporaryFolder folder;
  std::vector<std::string> files;
  for (const char* const title : {"first", "second"}) {
    files.push_back(folder / (std::string(title) + ".level"));
    writeText(files.back(), "# title: " + std::string(title) + "\n" + nearGoalText());
  }
  const auto plays = [](const std::string& title) {
    return [title](const NetworkClient& client) {
      const Round* const round = client.session() ? client.session()->round() : nullptr;
      return round && round->prediction().predicted().level().title == title;
    };
  };
  EmbeddedServer server(onLoopback(files));
  EXPECT_EQ(server.clients(), 0U);
  Guest guest(server.address());
  ASSERT_TRUE(guest.playUntil(plays("first")));
  EXPECT_TRUE(guest.playUntil([&](const NetworkClient&) { return server.clients() == 1; }));
  server.startNextLevel();
  EXPECT_TRUE(guest.playUntil(plays("second")));
}

}  // namespace
}  // namespace platon::embedded_server_test
