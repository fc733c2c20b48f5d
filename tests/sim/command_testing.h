#pragma once

#include <gtest/gtest.h>

#include <cstdio>
#include <string>
#include <vector>

#include "platon/game/recorder.h"
#include "tests/sim/commands.h"
#include "tests/support/files.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

namespace platon::sim {

/// Runs platon-sim to its end.
inline ProcessResult runProgram(const std::string& arguments, const std::string& inputFile = "") {
  ProcessOptions options;
  options.inputFile = inputFile;
  return runProcess(platonCommand("platon-sim", wordsOf(arguments)), options);
}

/// The path of a file in a folder that is removed at the end of the test program.
inline std::string pathOf(const std::string& name) {
  static const TemporaryFolder folder;
  return folder / name;
}

/// Writes a file; returns its path.
inline std::string fileWith(const std::string& name, const std::string& text) {
  writeText(pathOf(name), text);
  return pathOf(name);
}

/// Writes a level file; returns its path.
inline std::string levelFile() {
  return fileWith("level",
                  "HEXAHEDRON\n0 0 -180 0\n1 0 -190\n480\n%\n-240 -200 240 -200\n%\n-240 -200 240 -200\n%\n%\n%\n%\n");
}

/// Runs a command in this process and returns what it prints to stdout. Its exit code must be 0.
inline std::string outputOf(int (*command)(const std::vector<std::string>&),
                            const std::vector<std::string>& arguments) {
  testing::internal::CaptureStdout();
  EXPECT_EQ(command(arguments), 0);
  std::fflush(stdout);
  return testing::internal::GetCapturedStdout();
}

/// The hash in a JSON object; empty when there is none.
inline std::string hashIn(const std::string& json) {
  const std::size_t at = json.find("\"hash\":\"");
  return at == std::string::npos ? "" : json.substr(at + 8, 16);
}

/// Records 300 ticks of three players, with these arguments besides; returns the path of the recording.
inline std::string recordedFile(const std::vector<std::string>& more = {}) {
  const std::string path = pathOf("recording");
  std::vector<std::string> arguments{levelFile(), "--ticks", "300",      "--players", "3",
                                     "--drive",   "churn",   "--record", path};
  arguments.insert(arguments.end(), more.begin(), more.end());
  outputOf(runCommand, arguments);
  return path;
}

/// The bytes of a recording of 30 ticks that differs from its replay at tick 20, in one bit of the position of
/// entity 1.
inline std::string differingRecording() {
  Game game(loadLevel(readText(levelFile())).level);
  Recorder recorder(game, 1);
  const std::vector<Input> inputs(2, Input{Input::kPresent | Input::kRight});
  for (int tick = 1; tick <= 30; ++tick) {
    game.advance(inputs);
    if (tick == 20) {
      auto state = game.save();
      constexpr std::size_t kPositionOfEntity1 = 2 + 58 + 8;
      state[kPositionOfEntity1] ^= 1;
      EXPECT_TRUE(game.restore(state));
    }
    recorder.record(inputs, game);
  }
  recorder.finish(game);
  const auto bytes = recorder.takeBytes();
  return {bytes.begin(), bytes.end()};
}

}  // namespace platon::sim
