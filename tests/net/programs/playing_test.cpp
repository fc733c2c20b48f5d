#include <gtest/gtest.h>

#include <string>

#include "tests/net/support/server_fixture.h"
#include "tests/support/files.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

namespace platon::playing_test {
namespace {

class Play : public ServerTest {};

TEST_F(Play, TwoDemosFinishALevelTogether) {
  startServer();
  Process ann(
      platonCommand("platon-client", {address(), "--offscreen", "--demo", "--name", "Ann", "--seconds", "120"}));
  Process bob(
      platonCommand("platon-client", {address(), "--offscreen", "--demo", "--name", "Bob", "--seconds", "120"}));
  server().waitForError("round over");  // both have finished
  for (Process* client : {&ann, &bob}) client->signal(SIGTERM);
  EXPECT_EQ(ann.wait(), 0) << ann.errors();
  EXPECT_EQ(bob.wait(), 0) << bob.errors();
  stopServer();
}

TEST_F(Play, PlaysOnAnEmbeddedServerAndSavesAScreenshot) {
  const TemporaryFolder folder;
  const std::string picture = folder / "picture.png";
  Process client(platonCommand(
      "platon-client", {"--level", kLevel, "--offscreen", "--demo", "--seconds", "4", "--screenshot", picture}));
  EXPECT_EQ(client.wait(), 0) << client.errors();
  EXPECT_NE(client.output().find(picture), std::string::npos) << client.output();
  EXPECT_EQ(client.errors(), "");
  const std::string bytes = readText(picture);
  EXPECT_GT(bytes.size(), 20000u);  // a picture of only the background is smaller
  EXPECT_EQ(bytes.substr(0, 4), "\x89PNG");
}

TEST_F(Play, DrawsAReplayAndRefusesOneThatIsCutOff) {
  const TemporaryFolder folder;
  const std::string picture = folder / "picture.png";
  const std::string whole = "tests/determinism/golden/hexahedron.recording";
  const ProcessResult drawn = runProcess(
      platonCommand("platon-client", {"--replay", whole, "--offscreen", "--seconds", "3", "--screenshot", picture}));
  EXPECT_EQ(drawn.exitCode, 0) << drawn.errors;
  EXPECT_GT(readText(picture).size(), 20000U);
  const std::string cut = folder / "cut";
  writeText(cut, readText(whole).substr(0, 5000));
  const ProcessResult refused =
      runProcess(platonCommand("platon-client", {"--replay", cut, "--offscreen", "--screenshot", picture}));
  EXPECT_EQ(refused.exitCode, 3);
  EXPECT_TRUE(refused.errors.starts_with(cut + ": is a recording that is cut off: byte 5000: ")) << refused.errors;
}

TEST_F(Play, ReconnectsAfterARestartOfTheServer) {
  startServer();
  Process client(platonCommand("platon-client", {address(), "--offscreen", "--demo", "--seconds", "60"}));
  server().waitForError("round over");
  stopServer();
  client.waitForError("platon-client: the server ended the game: the server stops; reconnecting");
  restartServer();
  client.waitForError("platon-client: reconnected");
  server().waitForError("joined");
  client.signal(SIGTERM);
  EXPECT_EQ(client.wait(), 0) << client.errors();
  stopServer();
}

TEST_F(Play, ReportsAtTheEndThatTheServerHasStopped) {
  startServer();
  Process client(platonCommand("platon-client", {address(), "--offscreen", "--seconds", "6"}));
  server().waitForError("joined");
  stopServer();
  EXPECT_EQ(client.wait(), 1);
  EXPECT_NE(client.errors().find("time limit reached: the server ended the game"), std::string::npos)
      << client.errors();
}

TEST_F(Play, HearsWhatTheOperatorSays) {
  const TemporaryFolder folder = TemporaryFolder::forSockets();
  const std::string socket = folder / "console";
  const std::string commands = folder / "commands";
  writeText(commands, "say Restart at noon\n");
  startServer({"--socket", socket});
  Process client(platonCommand("platon-client", {address(), "--offscreen", "--seconds", "60"}));
  server().waitForError("joined");
  const ProcessResult console =
      runProcess(platonCommand("platon-server", {"--console", "--socket", socket}), {"", commands});
  EXPECT_EQ(console.exitCode, 0) << console.errors;
  EXPECT_EQ(console.output, "said to 1 player\n");
  client.waitForError("platon-client: the server says: Restart at noon");
  client.signal(SIGTERM);
  EXPECT_LE(client.wait(), 1) << client.errors();  // 1 if it has not received the level yet
  stopServer();
}

TEST_F(Play, IsRefusedByAFullServer) {
  startServer({"--max-players", "1"});
  Process first(platonCommand("platon-client", {address(), "--offscreen", "--demo", "--seconds", "60"}));
  server().waitForError("joined");
  Process second(platonCommand("platon-client", {address(), "--offscreen", "--seconds", "60"}));
  EXPECT_EQ(second.wait(), 1);
  EXPECT_NE(second.errors().find("the server is full"), std::string::npos) << second.errors();
  first.signal(SIGINT);
  EXPECT_EQ(first.wait(), 0) << first.errors();
  stopServer();
}

}  // namespace
}  // namespace platon::playing_test
