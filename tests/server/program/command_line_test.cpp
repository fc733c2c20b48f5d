#include "server/program/command_line.h"

#include <gtest/gtest.h>

#include "protocol/program_error.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace platon::command_line_test {
namespace {

CommandLine lineOf(std::vector<const char*> arguments) {
  arguments.insert(arguments.begin(), "platon-server");
  return readCommandLine(static_cast<int>(arguments.size()), arguments.data()).value();
}

ServerOptions read(const std::vector<const char*>& arguments) { return optionsOf(lineOf(arguments)); }

// The message when the arguments are refused.
std::string errorOf(const std::vector<const char*>& arguments) {
  try {
    read(arguments);
    return "none";
  } catch (const ProgramError& error) {
    EXPECT_EQ(error.exitCode(), ProgramError::kUsage);
    return error.what();
  }
}

TEST(CommandLine, DefaultsAreThoseOfTheManual) {
  const ServerOptions options = read({});
  EXPECT_TRUE(options.levels.empty());
  EXPECT_EQ(options.bind, "::");
  EXPECT_EQ(options.port, 7777);
  EXPECT_EQ(options.maxPlayers, 16u);
  EXPECT_EQ(options.maxPerAddress, 4u);
  EXPECT_EQ(options.name, "Platon");
  EXPECT_EQ(options.logFormat, LogFormat::kText);
  EXPECT_EQ(options.record, "");
  EXPECT_EQ(options.banFile, "");
  EXPECT_EQ(options.socket, "");
  EXPECT_EQ(options.metrics, "");
}

TEST(CommandLine, ItsOptionsOverrideTheFile) {
  const TemporaryFolder folder;
  const std::string file = folder / "server.toml";
  writeText(
      file,
      "levels = [\"a.level\", \"/b.level\"]\nport = 1234\nmax-players = 5\nmax-per-address = 6\n"
      "bind = \"127.0.0.1\"\nname = \"Ours\"\nlog-format = \"json\"\nrecord = \"games\"\nban-file = \"bans.txt\"\n"
      "socket = \"s\"\nmetrics = \"127.0.0.1:19777\"\n");
  const ServerOptions fromFile{{folder / "a.level", "/b.level"},
                               "127.0.0.1",
                               1234,
                               5,
                               6,
                               "Ours",
                               LogFormat::kJson,
                               folder / "games",
                               folder / "bans.txt",
                               folder / "s",
                               "127.0.0.1:19777"};
  EXPECT_EQ(read({"--config", file.c_str()}), fromFile);
  const ServerOptions both{{"c.level"}, "127.0.0.2",      1,        7,        8, "Mine", LogFormat::kText,
                           "rounds",    "other_bans.txt", "/run/s", "[::1]:0"};
  EXPECT_EQ(read({"--config",
                  file.c_str(),
                  "c.level",
                  "--bind",
                  "127.0.0.2",
                  "--port",
                  "1",
                  "--max-players",
                  "7",
                  "--max-per-address",
                  "8",
                  "--name",
                  "Mine",
                  "--log-format",
                  "text",
                  "--record",
                  "rounds",
                  "--ban-file",
                  "other_bans.txt",
                  "--socket",
                  "/run/s",
                  "--metrics",
                  "[::1]:0"}),
            both);
}

// Also where the value is the default.
TEST(CommandLine, AnOptionThatIsGivenOverridesTheFileWhateverItsValue) {
  const TemporaryFolder folder;
  const std::string file = folder / "server.toml";
  writeText(file, "port = 1234\nrecord = \"games\"\n");
  EXPECT_EQ(read({"--config", file.c_str(), "--port", "7777", "--record", ""}), ServerOptions{});
}

TEST(CommandLine, SaysWhatTheServerIsAskedToDo) {
  EXPECT_EQ(lineOf({}).task, ServerTask::kServe);
  EXPECT_EQ(lineOf({"--console", "--socket", "/run/s"}).task, ServerTask::kConsole);
  EXPECT_EQ(lineOf({"--print-config"}).task, ServerTask::kPrintConfig);
  EXPECT_EQ(lineOf({"--check-config", "--config", "x"}).task, ServerTask::kCheckConfig);
  EXPECT_EQ(lineOf({"--check-config", "--config", "x"}).config, "x");
  EXPECT_EQ(errorOf({"--console", "--print-config"}), "--console excludes --print-config (see platon-server --help)");
}

TEST(CommandLine, EveryErrorIsOneLine) {
  for (const std::vector<const char*>& arguments : {std::vector<const char*>{"--colour"},
                                                    {"--port", "65536"},
                                                    {"--port", "x"},
                                                    {"--port", "-1"},
                                                    {"--port", ""},
                                                    {"--max-players", "0"},
                                                    {"--name", "a\nb"},
                                                    {"--bind", "here"},
                                                    {"--bind", ""},
                                                    {"--log-format", "xml"},
                                                    {"--metrics", "19777"},
                                                    {"--config", "/no/such/file"},
                                                    {"--port"}}) {
    const std::string error = errorOf(arguments);
    EXPECT_NE(error, "none") << arguments.front();
    EXPECT_EQ(error.find('\n'), std::string::npos) << error;
  }
}

TEST(CommandLine, ErrorsNameTheOptionAndWhatItMustBe) {
  const std::string help = " (see platon-server --help)";
  EXPECT_EQ(errorOf({"--port", "70000"}), "--port must be a whole number from 0 to 65535" + help);
  EXPECT_EQ(errorOf({"--metrics", "19777"}),
            "--metrics must be an address and a port, such as 127.0.0.1:19777 or [::1]:19777" + help);
}

TEST(CommandLine, TheErrorsOfAFileAreCounted) {
  const TemporaryFolder folder;
  const std::string file = folder / "server.toml";
  writeText(file, "port = 70000\n");
  EXPECT_EQ(errorOf({"--config", file.c_str()}), file + ":1:8: error: port must be a whole number from 0 to 65535");
  writeText(file, "port = 70000\nname = 3\ncolour = 1\n");
  EXPECT_EQ(errorOf({"--config", file.c_str()}),
            file + ":1:8: error: port must be a whole number from 0 to 65535 (and 2 more: --check-config lists all)");
  EXPECT_EQ(readOptions(lineOf({"--config", file.c_str()})).errors.size(), 3u);
}

}  // namespace
}  // namespace platon::command_line_test
