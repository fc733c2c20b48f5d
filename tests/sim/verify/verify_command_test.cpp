#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "tests/shared/game/forged_recording.h"
#include "tests/shared/game/played_game.h"
#include "tests/sim/command_testing.h"
#include "tests/sim/hex_digits.h"
#include "tests/sim/sim_options.h"
#include "tests/sim/verify/verification.h"

namespace platon::sim::verify_command_test {
namespace {

using testing::HasSubstr;
using testing::MatchesRegex;

TEST(VerifyCommandTest, PrintsOneJsonObject) {
  const std::string path = recordedFile();
  const std::string json = outputOf(verifyCommand, {path, "--json"});
  EXPECT_THAT(
      json,
      MatchesRegex("\\{\"recording\":\"[^\"]*\",\"level\":\"[0-9a-f]+\",\"title\":\"[^\"]*\",\"firstTick\":0,"
                   "\"beginsInMidGame\":false,\"ticks\":300,\"players\":3,"
                   "\"hash\":\"[0-9a-f]+\",\"complete\":true,\"run\":null,"
                   "\"noRun\":\"is no run: it does not end with a player at the goal\",\"timesRealTime\":[0-9]+\\}\n"));
  EXPECT_EQ(
      hashIn(json),
      hashIn(outputOf(runCommand, {levelFile(), "--ticks", "300", "--players", "3", "--drive", "churn", "--json"})));
  EXPECT_THAT(outputOf(verifyCommand, {path, "--from", "130", "--json"}),
              HasSubstr("\"firstTick\":120,\"beginsInMidGame\":true,\"ticks\":180,"));
}

TEST(VerifyCommandTest, SaysWhetherARecordingIsARun) {
  const auto level = cubeLevel("0 0 -180 0", {"-240 -200 240 -200"}, "0 100 -190");
  const auto verified = [](const std::vector<std::uint8_t>& recording, const std::vector<std::string>& options) {
    std::vector<std::string> arguments{
        fileWith("run", {reinterpret_cast<const char*>(recording.data()), recording.size()})};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return outputOf(verifyCommand, arguments);
  };
  const auto run = recordToGoal(Game(level));
  const auto ticks = std::get<RunFinish>(Verifier(run).run().run).ticks;
  EXPECT_THAT(verified(run, {"--json"}), HasSubstr("\"run\":{\"player\":0,\"ticks\":" + std::to_string(ticks) + "},"));
  EXPECT_THAT(verified(run, {}), HasSubstr("is a run of player 0: " + std::to_string(ticks) + " ticks\n"));
  const auto forged = forgedRun(level, units(60));
  const std::string why = "is no run: its player does not begin at the start of the level, at rest";
  EXPECT_THAT(verified(forged, {"--json"}), HasSubstr("\"run\":null,\"noRun\":\"" + why + "\","));
  EXPECT_THAT(verified(forged, {}), HasSubstr(why + "\n"));
  const auto cut = std::span(run).first(run.size() - 1);
  EXPECT_EQ(std::get<std::string>(Verifier(cut).run().run), "is no run: it was not replayed to its end");
}

// Whoever makes a recording has chosen its level, which may have the title of another one.
TEST(VerifyCommandTest, NamesTheLevelByItsHashAndTitle) {
  const auto text = [](const std::string& goal) {
    return "# title: Run and jump\nHEXAHEDRON\n0 0 -180 0\n" + goal + "\n480\n%\n-240 -200 240 -200\n%\n%\n%\n%\n%\n";
  };
  for (const char* const goal : {"0 100 -190", "0 -150 -190"}) {
    const auto level = levelOf(text(goal));
    const auto run = recordToGoal(Game(level));
    const std::string path = fileWith("run", {reinterpret_cast<const char*>(run.data()), run.size()});
    const std::string hash = hexDigits(level->hash);
    EXPECT_THAT(outputOf(verifyCommand, {path}), HasSubstr("\nlevel " + hash + " Run and jump\nfirst tick 0\n"));
    EXPECT_THAT(outputOf(verifyCommand, {path, "--json"}),
                HasSubstr(",\"level\":\"" + hash + "\",\"title\":\"Run and jump\","));
  }
}

TEST(VerifyCommandTest, FromALaterCheckpointItIsNotKnownWhetherARecordingIsARun) {
  const std::string path = recordedFile({"--checkpoint-every", "50"});
  const std::string why = "may be a run, which is not known: the replay began at tick 100";
  EXPECT_THAT(outputOf(verifyCommand, {path, "--from", "149", "--json"}),
              HasSubstr("\"run\":null,\"noRun\":\"" + why + "\","));
  EXPECT_THAT(outputOf(verifyCommand, {path, "--from", "149"}), HasSubstr(why + "\n"));
  const std::string none = "is no run: it does not end with a player at the goal\n";
  EXPECT_THAT(outputOf(verifyCommand, {path, "--from", "49"}), HasSubstr(none)) << "from the beginning";
}

TEST(VerifyCommandTest, RecordsTheReplay) {
  const std::string path = recordedFile();
  const std::string copy = path + "_copy";
  std::remove(copy.c_str());
  outputOf(verifyCommand, {path, "--record", copy});
  EXPECT_EQ(readText(copy), readText(path));
  std::remove(copy.c_str());
  outputOf(verifyCommand, {path, "--record", copy, "--checkpoint-every", "1"});
  EXPECT_GT(readText(copy).size(), readText(path).size());
  EXPECT_EQ(hashIn(outputOf(verifyCommand, {copy, "--json"})), hashIn(outputOf(verifyCommand, {path, "--json"})));
}

TEST(VerifyCommandTest, ReplacesNoFile) {
  const std::string path = recordedFile();
  const std::string content = readText(path);
  EXPECT_THROW(verifyCommand({path, "--from", "200", "--record", path}), UsageError);
  EXPECT_EQ(readText(path), content);
  const std::string none = pathOf("none");
  EXPECT_EQ(runProgram("verify " + levelFile() + " --record " + none).exitCode, 3);
  EXPECT_FALSE(std::filesystem::exists(none)) << "nothing was replayed";
}

TEST(VerifyCommandTest, NamesTheErrorOfTruncatedAndDamagedRecordings) {
  const std::string path = recordedFile({"--checkpoint-every", "50"});
  const std::string content = readText(path);

  const std::string cut = fileWith("cut", content.substr(0, content.size() - 100));
  const ProcessResult truncated = runProgram("verify " + cut);
  EXPECT_EQ(truncated.exitCode, 3);
  EXPECT_THAT(truncated.errors,
              HasSubstr(cut + ": byte " + std::to_string(content.size() - 100) + ": the recording is truncated"));
  EXPECT_THAT(truncated.errors, HasSubstr("; the 300 ticks before agree"));

  std::string damaged = content;
  damaged[content.size() / 2] = static_cast<char>(damaged[content.size() / 2] + 1);
  const ProcessResult damage = runProgram("verify " + fileWith("damaged", damaged));
  EXPECT_EQ(damage.exitCode, 3);
  EXPECT_THAT(damage.errors, MatchesRegex("(.|\n)*: byte [0-9]+: (.|\n)*"));

  const ProcessResult level = runProgram("verify " + levelFile());
  EXPECT_EQ(level.exitCode, 3);
  EXPECT_EQ(level.errors, levelFile() + ": byte 0: not a recording, or an unsupported version\n");
  EXPECT_EQ(runProgram("verify").exitCode, 2);
  EXPECT_EQ(runProgram("verify " + pathOf("no such file")).exitCode, 2);
  EXPECT_EQ(runProgram("verify " + path).exitCode, 0);
}

TEST(VerifyCommandTest, NamesTickEntityAndFieldOfADesync) {
  const std::string path = fileWith("another_game", differingRecording());
  const ProcessResult found = runProgram("verify " + path);
  EXPECT_EQ(found.exitCode, 1);
  EXPECT_THAT(found.errors, HasSubstr(path + ": desync at tick 20: hash "));
  EXPECT_THAT(found.errors,
              HasSubstr("at the checkpoint of tick 20, position of entity 1 is the first field that differs: ("));
  EXPECT_THAT(runProgram("verify --json " + path).output,
              HasSubstr("\"comparedAt\":20,\"entity\":\"entity 1\",\"field\":\"position\",\"value\":\"("));
}

}  // namespace
}  // namespace platon::sim::verify_command_test
