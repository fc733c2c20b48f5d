// Votes and best times with the programs themselves.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "client/net/enet_link.h"
#include "client/session/network_client.h"
#include "client/time/steady_now.h"
#include "protocol/transport/server_address.h"
#include "server/times/best_times.h"
#include "tests/net/support/server_fixture.h"
#include "tests/support/files.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/wait_until.h"

namespace platon::round_play_test {
namespace {

/// A player in this program.
class Voter {
 public:
  Voter(const std::string& address, const std::string& name)
      : client_(enetLinks(parseServerAddress(address)), {name}, now()) {}

  void update() {
    client_.update(now(), [](const Game&, std::uint32_t) { return Input{}; });
  }
  bool plays() const { return session() && session()->round() && session()->round()->prediction().present(); }
  void toggleVote() { client_.toggleVote(); }
  const Session* session() const { return client_.session(); }

 private:
  static Time now() { return steadyClock().now(); }

  NetworkClient client_;
};

class RoundPlay : public ServerTest {
 protected:
  static constexpr const char* kSecond = "tests/determinism/golden/levels/tetrahedron.level";

  // Updates all until `done`. Returns whether it is done.
  static bool play(const std::vector<Voter*>& voters, const std::function<bool()>& done) {
    const auto update = [&] {
      for (Voter* voter : voters) voter->update();
    };
    return stepUntil(update, done);
  }

  // The best time in the file by the present rules; empty if there is none.
  std::string bestName() {
    const auto read = readBestTimes(file_);
    if (!std::holds_alternative<BestTimes>(read)) return "damaged";
    const DatedTime* best = std::get<BestTimes>(read).find({level_, kRulesVersion});
    return best ? best->time.name : "";
  }

  const TemporaryFolder folder_;
  const std::string file_ = folder_ / "best_times";
  const std::uint64_t level_ = loadLevel(readText(kLevel)).level->hash;
};

TEST_F(RoundPlay, AVoteOfMoreThanHalfMovesOn) {
  startServer({kSecond});
  Voter ann(address(), "Ann");
  Voter ben(address(), "Ben");
  const std::vector<Voter*> all{&ann, &ben};
  ASSERT_TRUE(play(all, [&] { return ann.plays() && ben.plays(); }));
  ann.toggleVote();
  ASSERT_TRUE(play(all, [&] { return ben.session()->voteCount() == VoteCount{1, 1, 2}; }));
  EXPECT_FALSE(ben.session()->roundEnd());
  ben.toggleVote();
  ASSERT_TRUE(play(all, [&] { return ann.session()->roundEnd() && ben.session()->roundEnd(); }));
  const LevelResult next = loadLevel(readText(kSecond));
  EXPECT_EQ(ann.session()->roundEnd()->nextTitle, next.level->title);
  ASSERT_TRUE(play(all, [&] { return ann.plays() && ann.session()->round()->id() == 2; }));
  EXPECT_EQ(ann.session()->round()->prediction().confirmed().level().hash, next.level->hash);
  EXPECT_NE(server().errors().find("cause=\"vote\""), std::string::npos) << server().errors();
  stopServer();
}

TEST_F(RoundPlay, ABestTimeOutlivesAKilledServerAndIsAnnounced) {
  startServer({"--best-times", file_});
  {
    Process ann(
        platonCommand("platon-client", {address(), "--offscreen", "--demo", "--name", "Ann", "--seconds", "60"}));
    server().waitForError("round over");
    EXPECT_TRUE(waitUntil([&] { return bestName() == "Ann"; })) << server().errors();
    server().signal(SIGKILL);
    server().wait();
    ann.signal(SIGTERM);
    ann.wait();
  }
  EXPECT_EQ(bestName(), "Ann");
  startServer({"--best-times", file_});
  Voter ben(address(), "Ben");
  ASSERT_TRUE(play({&ben}, [&] { return ben.plays(); }));
  ben.toggleVote();
  ASSERT_TRUE(play({&ben}, [&] { return ben.session()->roundEnd() != nullptr; }));
  const auto& best = ben.session()->roundEnd()->best;
  ASSERT_TRUE(best);
  EXPECT_EQ(best->name, "Ann");
  EXPECT_FALSE(best->isNew);
  stopServer();
}

TEST_F(RoundPlay, ADamagedFileOfBestTimesIsRefusedAtTheStart) {
  writeText(file_, "# fine\n0123456789abcdef 6 0 2026-12-01T18:00:00Z Ann\n");
  for (const char* option : {"--check-config", "--port=0"}) {
    const ProcessResult result = runProcess(platonCommand("platon-server", {kLevel, "--best-times", file_, option}));
    EXPECT_EQ(result.exitCode, 2);
    EXPECT_NE(result.errors.find(file_ + ":2:20: error: "), std::string::npos) << result.errors;
  }
}

TEST_F(RoundPlay, AFileThatCannotBeWrittenIsLoggedOnceAndTheServerGoesOn) {
  const std::filesystem::path missing = folder_ / "missing";
  std::filesystem::create_directory(missing);
  startServer({"--best-times", missing / "best_times"});
  std::filesystem::remove(missing);
  Process ann(platonCommand("platon-client", {address(), "--offscreen", "--demo", "--name", "Ann", "--seconds", "60"}));
  server().waitForError("best times not written");
  server().waitForError("round started");
  std::filesystem::create_directory(missing);
  server().waitForError("best times written");
  ann.signal(SIGTERM);
  EXPECT_EQ(ann.wait(), 0) << ann.errors();
  stopServer();
  const std::string log = server().errors();
  EXPECT_EQ(log.find("best times not written"), log.rfind("best times not written")) << log;
}

}  // namespace
}  // namespace platon::round_play_test
