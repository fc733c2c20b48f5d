#include "server/app/server_options.h"

#include <gtest/gtest.h>

#include "protocol/program_error.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace platon {
namespace {

std::optional<ServerOptions> read(std::vector<const char*> arguments) {
  arguments.insert(arguments.begin(), "platon-server");
  return readOptions(static_cast<int>(arguments.size()), arguments.data());
}

TEST(ServerOptions, DefaultsAreThoseOfTheManual) {
  const auto options = read({});
  ASSERT_TRUE(options);
  EXPECT_TRUE(options->levels.empty());
  EXPECT_EQ(options->bind, "::");
  EXPECT_EQ(options->port, 7777);
  EXPECT_EQ(options->maxPlayers, 16u);
  EXPECT_EQ(options->maxPerAddress, 4u);
  EXPECT_EQ(options->name, "Platon");
  EXPECT_EQ(options->logFormat, LogFormat::kText);
  EXPECT_EQ(options->record, "");
}

TEST(ServerOptions, CommandLineOptionsOverrideTheFile) {
  const TemporaryFolder folder;
  const std::string file = folder / "server.toml";
  writeText(file,
            "levels = [\"a.level\", \"/b.level\"]\nport = 1234\nmax-players = 5\nmax-per-address = 6\n"
            "bind = \"127.0.0.1\"\nname = \"Ours\"\nlog-format = \"json\"\nrecord = \"games\"\n");
  const ServerOptions fromFile{
      {folder / "a.level", "/b.level"}, "127.0.0.1", 1234, 5, 6, "Ours", LogFormat::kJson, folder / "games"};
  EXPECT_EQ(read({"--config", file.c_str()}), fromFile);
  const ServerOptions both{{"c.level"}, "127.0.0.2", 1, 7, 8, "Mine", LogFormat::kText, "rounds"};
  EXPECT_EQ(read({"--config", file.c_str(), "c.level", "--bind", "127.0.0.2", "--port", "1", "--max-players", "7",
                  "--max-per-address", "8", "--name", "Mine", "--log-format", "text", "--record", "rounds"}),
            both);
}

TEST(ServerOptions, EveryErrorIsOneLine) {
  for (const std::vector<const char*>& arguments : {std::vector<const char*>{"--colour"},
                                                    {"--port", "65536"},
                                                    {"--port", "x"},
                                                    {"--max-players", "0"},
                                                    {"--name", "a\nb"},
                                                    {"--log-format", "xml"},
                                                    {"--config", "/no/such/file"},
                                                    {"--port"}}) {
    try {
      read(arguments);
      ADD_FAILURE() << arguments.front();
    } catch (const ProgramError& error) {
      EXPECT_EQ(error.exitCode(), ProgramError::kUsage);
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace platon
