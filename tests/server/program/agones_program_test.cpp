// The program platon-server under a stand-in for Agones.
#include <gtest/gtest.h>

#include <functional>
#include <optional>

#include "protocol/to_server.h"
#include "tests/net/support/enet_client.h"
#include "tests/net/support/server_fixture.h"
#include "tests/server/fleet/fake_sidecar.h"
#include "tests/support/environment_variable.h"
#include "tests/support/wait_until.h"

namespace platon::agones_program_test {
namespace {

const std::string kOnePlayer = "PATCH /v1beta1/counters/players {\"count\":\"1\",\"capacity\":\"16\"}";
const std::string kTwoPlayers = "PATCH /v1beta1/counters/players {\"count\":\"2\",\"capacity\":\"16\"}";
const std::string kNoPlayer = "PATCH /v1beta1/counters/players {\"count\":\"0\",\"capacity\":\"16\"}";

class AgonesProgramTest : public ServerTest {
 protected:
  std::uint16_t serverPort() const {
    return static_cast<std::uint16_t>(std::stoi(address().substr(address().rfind(':') + 1)));
  }

  bool reaches(const std::string& call, std::size_t calls = 1) {
    return waitUntil([&] { return sidecar_.count(call) >= calls; });
  }

  void join() { join(ann_, "Ann"); }

  void join(std::optional<EnetClient>& player, const std::string& name) {
    player.emplace(serverPort(), FakeClient(name, 8, [](std::uint32_t) { return 0; }));
    EXPECT_TRUE(stepUntil(step_, [&] { return player->fake().confirmed() >= 10; }));
  }

  // Steps the players until the sidecar has taken the call.
  bool playsUntil(const std::string& call, std::size_t calls = 1) {
    return stepUntil(step_, [&] { return sidecar_.count(call) >= calls; });
  }

  // Whether the server plays half a second of the game while it waits for the answer to a call, for which it waits a
  // second. A busy machine may do it in the next call.
  bool playsDuringACall() {
    std::size_t call = 0;
    std::uint32_t begun = 0;
    return stepUntil(step_, [&] {
      const std::uint32_t confirmed = ann_->fake().confirmed();
      if (const std::size_t now = sidecar_.unanswered(); now != call) {
        call = now;
        begun = confirmed;
      }
      return call != 0 && confirmed >= begun + 30;
    });
  }

  FakeSidecar sidecar_;
  const EnvironmentVariable port_{"AGONES_SDK_HTTP_PORT", std::to_string(sidecar_.port())};
  std::optional<EnetClient> ann_;
  std::optional<EnetClient> bob_;
  const std::function<void()> step_ = [this] {
    ann_->step();
    if (bob_) bob_->step();
  };
};

TEST_F(AgonesProgramTest, TheSidecarIsToldTheLifeOfTheServerInOrder) {
  startServer({"--drain", "600"});
  ASSERT_TRUE(reaches("POST /health"));
  EXPECT_EQ(sidecar_.calls()[0], "POST /ready {}");
  EXPECT_EQ(sidecar_.calls()[1], "POST /health {}");
  ASSERT_TRUE(reaches(kNoPlayer));
  EXPECT_EQ(sidecar_.count("POST /allocate"), 0u);
  join();
  ASSERT_TRUE(playsUntil(kOnePlayer));
  EXPECT_EQ(sidecar_.count("POST /allocate"), 1u);
  EXPECT_EQ(sidecar_.count("POST /shutdown"), 0u);
  server().signal(SIGTERM);
  server().waitForError("draining seconds=600");
  ann_->sendRaw(encode(Leave{}), true);
  EXPECT_TRUE(stepUntil(step_, [this] { return ann_->disconnected(); }));
  EXPECT_EQ(server().wait(), 0);
  EXPECT_EQ(sidecar_.calls().back(), "POST /shutdown {}");
  EXPECT_EQ(sidecar_.count("POST /shutdown"), 1u);
  EXPECT_EQ(sidecar_.faults(), std::vector<std::string>{});
}

TEST_F(AgonesProgramTest, AServerWhosePlayersHaveLeftHasFreePlaces) {
  startServer();
  join();
  ASSERT_TRUE(playsUntil(kOnePlayer));
  ann_->sendRaw(encode(Leave{}), true);
  ASSERT_TRUE(playsUntil(kNoPlayer));
  stopServer();
}

TEST_F(AgonesProgramTest, AServerWhosePlayersHaveLeftLooksWhenItWasAllocated) {
  startServer();
  join();
  ASSERT_TRUE(playsUntil(kOnePlayer));
  EXPECT_EQ(sidecar_.count("GET /gameserver"), 0u);
  ann_->sendRaw(encode(Leave{}), true);
  ASSERT_TRUE(playsUntil("GET /gameserver"));
  ASSERT_TRUE(playsUntil("POST /health", sidecar_.count("POST /health") + 1));
  EXPECT_EQ(sidecar_.count("GET /gameserver"), 1u) << "the next look is 30 s later";
  EXPECT_EQ(sidecar_.count("POST /ready"), 1u);
  EXPECT_EQ(sidecar_.faults(), std::vector<std::string>{});
  stopServer();
  EXPECT_EQ(server().errors().find("agones call fails"), std::string::npos);
}

TEST_F(AgonesProgramTest, ASidecarThatComesLateIsToldAllOfIt) {
  sidecar_.vanish();
  startServer();
  server().waitForError("agones call fails call=\"ready\" reason=\"Connection refused\"");
  join();
  sidecar_.comeBack();
  ASSERT_TRUE(playsUntil(kOnePlayer));
  server().waitForError("agones call succeeds again call=\"ready\"");
  EXPECT_EQ(sidecar_.count("POST /allocate"), 1u);
  stopServer();
}

// The calls take effect, and are made again because the server does not know that.
TEST_F(AgonesProgramTest, ASidecarThatAnswersLateHoldsTheRightNumber) {
  startServer();
  ASSERT_TRUE(reaches(kNoPlayer));
  sidecar_.set(FakeSidecar::Mode::kIsLate);
  join();
  EXPECT_TRUE(playsDuringACall());
  ASSERT_TRUE(playsUntil("POST /allocate", 2));
  ASSERT_TRUE(playsUntil(kOnePlayer, 2));
  server().waitForError("agones call fails call=\"players\" reason=\"it does not answer in time\"");
  sidecar_.set(FakeSidecar::Mode::kAnswers);
  ASSERT_TRUE(playsUntil(kOnePlayer, 3));
  EXPECT_EQ(sidecar_.count(kNoPlayer), 1u);
  EXPECT_EQ(sidecar_.faults(), std::vector<std::string>{});
  stopServer();
  EXPECT_EQ(sidecar_.calls().back(), "POST /shutdown {}");
}

TEST_F(AgonesProgramTest, ASidecarThatIsGoneForAWhileInPlayIsToldWhatHasChanged) {
  startServer();
  join();
  ASSERT_TRUE(playsUntil(kOnePlayer));
  sidecar_.vanish();
  join(bob_, "Bob");
  server().waitForError("agones call fails call=\"players\" reason=\"Connection refused\"");
  EXPECT_EQ(sidecar_.count(kTwoPlayers), 0u);
  sidecar_.comeBack();
  ASSERT_TRUE(playsUntil(kTwoPlayers));
  server().waitForError("agones call succeeds again call=\"players\"");
  EXPECT_EQ(sidecar_.count("POST /allocate"), 1u);
  stopServer();
}

TEST_F(AgonesProgramTest, ASidecarThatRefusesOrIsSilentHoldsUpNoTick) {
  for (const FakeSidecar::Mode mode : {FakeSidecar::Mode::kRefuses, FakeSidecar::Mode::kIsSilent}) {
    sidecar_.set(mode);
    startServer();
    join();
    const std::uint32_t before = ann_->fake().confirmed();
    const std::size_t requests = sidecar_.requests();
    EXPECT_TRUE(stepUntil(step_, [&] { return sidecar_.requests() >= requests + 3; }));
    EXPECT_GT(ann_->fake().confirmed(), before);
    EXPECT_TRUE(mode == FakeSidecar::Mode::kRefuses || playsDuringACall());
    EXPECT_EQ(ann_->fake().desyncs(), 0u);
    server().signal(SIGTERM);
    EXPECT_EQ(server().wait(), 0);
    EXPECT_NE(server().errors().find("\nagones was not told that the server stops\n"), std::string::npos);
  }
}

TEST_F(AgonesProgramTest, AnInvalidPortIsRefusedAtTheStart) {
  const EnvironmentVariable wrong("AGONES_SDK_HTTP_PORT", "http");
  const ProcessResult result = runProcess(platonCommand("platon-server", {kLevel, "--port", "0"}));
  EXPECT_EQ(result.exitCode, 2);
  EXPECT_NE(result.errors.find("AGONES_SDK_HTTP_PORT must be a port from 1 to 65535, not 'http'"), std::string::npos);
}

}  // namespace
}  // namespace platon::agones_program_test
