#include "tests/sim/commands.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

#include "platon/game/game.h"
#include "platon/game/recorder.h"
#include "tests/sim/files.h"
#include "tests/sim/sim_options.h"
#include "tests/support/files.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

namespace platon::sim {
namespace {

using testing::HasSubstr;
using testing::MatchesRegex;
using testing::StartsWith;

ProcessResult runProgram(const std::string& arguments, const std::string& inputFile = "") {
  ProcessOptions options;
  options.inputFile = inputFile;
  return runProcess(platonCommand("platon-sim", wordsOf(arguments)), options);
}

// The path of a file in a folder that lives as long as this program.
std::string pathOf(const std::string& name) {
  static const TemporaryFolder folder;
  return folder / name;
}

std::string fileWith(const std::string& name, const std::string& text) {
  writeText(pathOf(name), text);
  return pathOf(name);
}

std::string levelFile() {
  return fileWith("level",
                  "HEXAHEDRON\n0 0 -180 0\n1 0 -190\n480\n%\n-240 -200 240 -200\n%\n-240 -200 240 -200\n%\n%\n%\n%\n");
}

std::string sweepAnswers(const std::string& queries, int expectedStatus = 0) {
  std::ios::sync_with_stdio(false);  // or the command's own call would put the old buffer back
  std::istringstream in(queries);
  std::streambuf* const before = std::cin.rdbuf(in.rdbuf());
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  EXPECT_EQ(sweepCommand({}), expectedStatus);
  std::fflush(stdout);
  std::cin.rdbuf(before);
  std::cin.clear();
  return testing::internal::GetCapturedStdout() + testing::internal::GetCapturedStderr();
}

TEST(SweepCommandTest, AnswersLineByLine) {
  const std::string square = "4 -10 -10 10 -10 10 10 -10 10  ";
  EXPECT_EQ(sweepAnswers(square + "0 0  0 -40  -50 -30 50 -30\n"), "hit 2000 4000 0 100\n");
  EXPECT_EQ(sweepAnswers(square + "0 0  0 -20  -50 -30 50 -30\n"), "miss\n") << "touching is no meeting";
  EXPECT_EQ(sweepAnswers(square + "0 0  0 0  -50 -5 50 -5\n"), "hit 0 1 0 0\n");
  EXPECT_EQ(sweepAnswers(square + "0 0  0 0  -50 -50 50 -50\r\n" + square + "0 0 0 0 0 0 0 0"), "miss\nhit 0 1 0 0\n");
  EXPECT_EQ(sweepAnswers(""), "");
}

TEST(SweepCommandTest, ABadLineIsNamedAndTheOthersAnswered) {
  const std::string good = "3 0 0 9 0 0 9  0 0  0 0  50 50 50 50\n";
  EXPECT_EQ(sweepAnswers(good + "3 0 0 9 0\n" + good, 3),
            "miss\nmiss\nline 2: the line ends before a vertex coordinate\n");
  EXPECT_THAT(sweepAnswers("2 0 0 9 0 0 0 0 0 0 0 0 0\n", 3),
              HasSubstr("line 1: '2' should be the number of vertices"));
  EXPECT_THAT(sweepAnswers("3 0 0 9 0 0 9  0 0  0 0  50 50 50 536870912\n", 3),
              StartsWith("line 1: '536870912' should be"));
  EXPECT_THAT(sweepAnswers("3 0 0 9 0 0 9  0 0  0 0  50 50 50 50 1\n", 3),
              HasSubstr("more on the line than one query"));
  EXPECT_THAT(sweepAnswers("3 0 0 0 9 9 0  0 0  0 0  50 50 50 50\n", 3), HasSubstr("turns clockwise"));
  EXPECT_THAT(sweepAnswers("\n", 3), StartsWith("line 1: "));
}

TEST(SweepCommandTest, TakesNoArguments) { EXPECT_THROW(sweepCommand({"file"}), UsageError); }

std::string ran(const std::vector<std::string>& arguments,
                int (*command)(const std::vector<std::string>&) = runCommand) {
  testing::internal::CaptureStdout();
  EXPECT_EQ(command(arguments), 0);
  std::fflush(stdout);
  return testing::internal::GetCapturedStdout();
}

std::string hashIn(const std::string& json) {
  const std::size_t at = json.find("\"hash\":\"");
  return at == std::string::npos ? "" : json.substr(at + 8, 16);
}

TEST(RunCommandTest, PrintsOneJsonObject) {
  const std::string level = levelFile();
  const std::string json = ran({level, "--players", "3", "--ticks", "200", "--seed", "9", "--json"});
  EXPECT_THAT(json,
              MatchesRegex("\\{\"level\":\"[^\"]*\",\"players\":3,\"ticks\":200,\"seed\":9,\"hash\":\"[0-9a-f]+\","
                           "\"crossings\":[0-9]+,\"goals\":[0-9]+,\"nsPerPlayerTick\":[0-9.]+\\}\n"));
  EXPECT_EQ(hashIn(json).size(), 16u);
}

TEST(RunCommandTest, TheSeedDecidesTheHash) {
  const std::string level = levelFile();
  for (const char* drive : {"play", "fling"}) {
    const auto hashOf = [&](const char* seed) {
      return hashIn(ran({level, "--ticks", "300", "--players", "2", "--drive", drive, "--seed", seed, "--json"}));
    };
    EXPECT_EQ(hashOf("4"), hashOf("4")) << drive;
    EXPECT_NE(hashOf("4"), hashOf("5")) << drive;
  }
}

TEST(RunCommandTest, PushedAlongTheFloorItCrossesTheEdge) {
  const std::string json = ran({levelFile(), "--drive", "push", "--velocity", "4096,-256", "--ticks", "100", "--json"});
  EXPECT_THAT(json, HasSubstr("\"crossings\":1,"));
}

TEST(RunCommandTest, WritingATraceChangesNothing) {
  const std::string level = levelFile();
  const std::string trace = pathOf("trace");
  const std::vector<std::string> plain{level, "--ticks", "50", "--json"};
  std::vector<std::string> traced = plain;
  traced.insert(traced.end(), {"--trace", trace});
  const std::string hash = hashIn(ran(plain));
  EXPECT_EQ(hashIn(ran(traced)), hash);
  std::ifstream file(trace);
  std::string line;
  std::string last;
  int lines = 0;
  while (std::getline(file, line)) {
    if (lines++ == 0) {
      EXPECT_THAT(line, StartsWith("{\"solid\":\"HEXAHEDRON\",\"subunits\":1024,\"shape\":[["));
    }
    last = line;
  }
  EXPECT_EQ(lines, 51);
  EXPECT_THAT(last, StartsWith("{\"tick\":50,\"hash\":\"" + hash + "\",\"players\":[{\"id\":0,\"legs\":[["));
}

TEST(RunCommandTest, RefusesWhatItCannotFollow) {
  const std::string level = levelFile();
  EXPECT_THROW(runCommand({}), UsageError);
  EXPECT_THROW(runCommand({level, level}), UsageError);
  EXPECT_THROW(runCommand({level, "--players", "0"}), UsageError);
  EXPECT_THROW(runCommand({level, "--players", "257"}), UsageError);
  EXPECT_THROW(runCommand({level, "--ticks", "1", "--drive", "swim"}), UsageError);
  EXPECT_THROW(runCommand({level, "--ticks", "1", "--drive", "push"}), UsageError);
  EXPECT_THROW(runCommand({level, "--ticks", "1", "--drive", "push", "--velocity", "5"}), UsageError);
  EXPECT_THROW(runCommand({level, "--ticks", "1", "--drive", "push", "--velocity", "268435456,0"}), UsageError);
  EXPECT_THROW(runCommand({pathOf("no such level")}), UsageError);
}

// A recording of 300 ticks; its path.
std::string recordedFile(const std::vector<std::string>& more = {}) {
  const std::string path = pathOf("recording");
  std::vector<std::string> arguments{levelFile(), "--ticks", "300",      "--players", "3",
                                     "--drive",   "churn",   "--record", path};
  arguments.insert(arguments.end(), more.begin(), more.end());
  ran(arguments);
  return path;
}

TEST(VerifyCommandTest, PrintsOneJsonObject) {
  const std::string path = recordedFile();
  const std::string json = ran({path, "--json"}, verifyCommand);
  EXPECT_THAT(json, MatchesRegex("\\{\"recording\":\"[^\"]*\",\"firstTick\":0,\"ticks\":300,\"players\":3,"
                                 "\"hash\":\"[0-9a-f]+\",\"complete\":true,\"timesRealTime\":[0-9]+\\}\n"));
  EXPECT_EQ(hashIn(json), hashIn(ran({levelFile(), "--ticks", "300", "--players", "3", "--drive", "churn", "--json"})));
  EXPECT_THAT(ran({path, "--from", "130", "--json"}, verifyCommand), HasSubstr("\"firstTick\":120,\"ticks\":180,"));
}

TEST(VerifyCommandTest, RecordsWhatItPlaysAgain) {
  const std::string path = recordedFile();
  const std::string again = path + "_again";
  std::remove(again.c_str());
  ran({path, "--record", again}, verifyCommand);
  EXPECT_EQ(readText(again), readText(path));
  std::remove(again.c_str());
  ran({path, "--record", again, "--checkpoint-every", "1"}, verifyCommand);
  EXPECT_GT(readText(again).size(), readText(path).size());
  EXPECT_EQ(hashIn(ran({again, "--json"}, verifyCommand)), hashIn(ran({path, "--json"}, verifyCommand)));
}

TEST(VerifyCommandTest, WritesOverNothing) {
  const std::string path = recordedFile();
  const std::string content = readText(path);
  EXPECT_THROW(verifyCommand({path, "--from", "200", "--record", path}), UsageError);
  EXPECT_EQ(readText(path), content);
  const std::string none = pathOf("none");
  EXPECT_EQ(runProgram("verify " + levelFile() + " --record " + none).exitCode, 3);
  EXPECT_FALSE(std::filesystem::exists(none)) << "nothing was played";
}

TEST(VerifyCommandTest, OnlyGamesAreRecorded) {
  EXPECT_THROW(runCommand({levelFile(), "--drive", "fling", "--record", pathOf("r")}), UsageError);
  EXPECT_THROW(runCommand({levelFile(), "--record", pathOf("no such folder/r")}), UsageError);
  EXPECT_THROW(runCommand({levelFile(), "--checkpoint-every", "0"}), UsageError);
}

// Exit code and sentence, on a recording that a game of other physics left, a cut and a damaged one.
TEST(VerifyCommandTest, SaysWhatIsWrong) {
  const std::string path = recordedFile({"--checkpoint-every", "50"});
  const std::string content = readText(path);

  const std::string cut = fileWith("cut", content.substr(0, content.size() - 100));
  const ProcessResult truncated = runProgram("verify " + cut);
  EXPECT_EQ(truncated.exitCode, 3);
  EXPECT_THAT(truncated.errors,
              HasSubstr(cut + ": byte " + std::to_string(content.size() - 100) + ": the recording ends here"));
  EXPECT_THAT(truncated.errors, HasSubstr("; 300 ticks before it were played and agree"));

  std::string damaged = content;
  damaged[content.size() / 2] = static_cast<char>(damaged[content.size() / 2] + 1);
  const ProcessResult damage = runProgram("verify " + fileWith("damaged", damaged));
  EXPECT_EQ(damage.exitCode, 3);
  EXPECT_THAT(damage.errors, MatchesRegex("(.|\n)*: byte [0-9]+: (.|\n)*"));

  EXPECT_EQ(runProgram("verify " + levelFile()).exitCode, 3);
  EXPECT_EQ(runProgram("verify").exitCode, 2);
  EXPECT_EQ(runProgram("verify " + pathOf("no such file")).exitCode, 2);
  EXPECT_EQ(runProgram("verify " + path).exitCode, 0);
}

// One bit of the state is not what is played: tick, entity and field are named, and the exit code is 1.
TEST(VerifyCommandTest, NamesTickEntityAndField) {
  const std::string path = pathOf("another_game");
  Game game(loadLevel(readText(levelFile())).level);
  Recorder recorder(game, 1);
  const std::vector<Input> inputs(2, Input{Input::kPresent | Input::kRight});
  for (int tick = 0; tick < 30; ++tick) {
    game.advance(inputs);
    if (tick == 19) {
      auto state = game.save();
      constexpr std::size_t kPositionOfEntity1 = 2 + 58 + 8;
      state[kPositionOfEntity1] ^= 1;
      ASSERT_TRUE(game.restore(state));
    }
    recorder.record(inputs, game);
  }
  recorder.finish(game);
  OutputFile file(path);
  file.write(recorder.takeBytes());
  file.close();
  const ProcessResult found = runProgram("verify " + path);
  EXPECT_EQ(found.exitCode, 1);
  EXPECT_THAT(found.errors, HasSubstr(path + ": after tick 20 the hash is "));
  EXPECT_THAT(found.errors, HasSubstr("; there the first field that differs is position of entity 1: ("));
  EXPECT_THAT(runProgram("verify --json " + path).output,
              HasSubstr("\"comparedAt\":20,\"entity\":\"entity 1\",\"field\":\"position\",\"value\":\"("));
}

TEST(WorldCommandTest, RunsAScene) {
  const std::string scene = fileWith("scene", "shape 0 0 9 0 0 9\nline -500 -30 500 -30\nentity 0 0\nvelocity 5 -5\n");
  const std::string json = ran({scene, "--ticks", "20", "--json"}, worldCommand);
  EXPECT_THAT(json, HasSubstr("\"entities\":1,\"ticks\":20,\"hash\":\""));
  EXPECT_EQ(hashIn(json), hashIn(ran({scene, "--ticks", "20", "--json"}, worldCommand)));
  EXPECT_NE(hashIn(json), hashIn(ran({scene, "--ticks", "21", "--json"}, worldCommand)));
  EXPECT_NE(hashIn(json), hashIn(ran({scene, "--ticks", "20", "--max-speed", "9", "--json"}, worldCommand)));
  EXPECT_THROW(worldCommand({fileWith("bad", "line 1\n")}), InputError);
}

TEST(ProgramTest, SaysWhatItIs) {
  EXPECT_THAT(runProgram("--help").output, StartsWith("platon-sim: runs the simulation"));
  EXPECT_EQ(runProgram("--help").exitCode, 0);
  EXPECT_EQ(runProgram("run --help").exitCode, 0);
  EXPECT_THAT(runProgram("--version").output, MatchesRegex("platon-sim [0-9]+\\.[0-9]+\\.[0-9]+\n"));
}

TEST(ProgramTest, ExitCodesSayWhatWentWrong) {
  EXPECT_EQ(runProgram("").exitCode, 2);
  EXPECT_EQ(runProgram("swim").exitCode, 2);
  EXPECT_EQ(runProgram("run").exitCode, 2);
  EXPECT_EQ(runProgram("run --ticks many " + levelFile()).exitCode, 2);
  const std::string broken = fileWith("broken", "HEXAHEDRON\n0 0 0 0\n0 0 0\n480\n");
  const ProcessResult invalid = runProgram("run " + broken);
  EXPECT_EQ(invalid.exitCode, 3);
  EXPECT_THAT(invalid.errors, HasSubstr(broken + ":"));
  EXPECT_THAT(invalid.errors, HasSubstr(": error: "));
  EXPECT_EQ(runProgram("world " + fileWith("bad", "line 1\n") + " --ticks 1").exitCode, 3);
  EXPECT_EQ(runProgram("sweep", fileWith("queries", "nothing\n")).exitCode, 3);
  EXPECT_EQ(runProgram("run --ticks 5 " + levelFile()).exitCode, 0);
}

}  // namespace
}  // namespace platon::sim
