#include "server/app/server_options.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "protocol/program_error.h"
#include "server/app/level_files.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_levels.h"

namespace platon {
namespace {

std::optional<ServerOptions> read(std::vector<const char*> arguments) {
  arguments.insert(arguments.begin(), "platon-server");
  return readOptions(static_cast<int>(arguments.size()), arguments.data());
}

/// The sentence, after the exit code.
template <class Call>
std::string fault(Call call) {
  try {
    call();
    return "none";
  } catch (const ProgramError& error) {
    return std::to_string(error.exitCode()) + " " + error.what();
  }
}

class OptionsTest : public testing::Test {
 protected:
  std::string write(const std::string& name, const std::string& text) const {
    writeText(folder_ / name, text);
    return folder_ / name;
  }

  const TemporaryFolder folder_;
};

TEST_F(OptionsTest, DefaultsAreThoseOfTheManual) {
  const auto options = read({});
  ASSERT_TRUE(options);
  EXPECT_TRUE(options->levels.empty());
  EXPECT_EQ(options->bind, "0.0.0.0");
  EXPECT_EQ(options->port, 7777);
  EXPECT_EQ(options->maxPlayers, 16u);
  EXPECT_EQ(options->maxPerAddress, 4u);
  EXPECT_EQ(options->record, "");
}

TEST_F(OptionsTest, TheCommandLineGoesBeforeTheFile) {
  const std::string file = write("server.toml",
                                 "levels = [\"a.level\", \"/b.level\"]\nport = 1234\nmax-players = 5\n"
                                 "max-per-address = 6\nbind = \"127.0.0.1\"\nname = \"Ours\"\n"
                                 "log-format = \"json\"\nrecord = \"games\"\n");
  const ServerOptions fromFile{{(folder_ / "a.level").string(), "/b.level"},
                               "127.0.0.1",
                               1234,
                               5,
                               6,
                               "Ours",
                               LogFormat::kJson,
                               (folder_ / "games").string()};
  EXPECT_EQ(read({"--config", file.c_str()}), fromFile);
  const ServerOptions both{{"c.level"}, "127.0.0.2", 1, 7, 8, "Mine", LogFormat::kText, "rounds"};
  EXPECT_EQ(read({"--config", file.c_str(), "c.level", "--bind", "127.0.0.2", "--port", "1", "--max-players", "7",
                  "--max-per-address", "8", "--name", "Mine", "--log-format", "text", "--record", "rounds"}),
            both);
}

TEST_F(OptionsTest, FaultsOfTheFileHaveALineAndAColumn) {
  const auto faultOf = [this](const std::string& text) {
    const std::string file = write("server.toml", text);
    const std::string what = fault([&] { read({"--config", file.c_str()}); });
    return what.starts_with("2 " + file) ? what.substr(2 + file.size()) : what;
  };
  EXPECT_EQ(faultOf("port = 1\n  colour = 2\n"),
            ":2:3: error: colour is no key of the configuration; it may hold levels, bind, port, max-players, "
            "max-per-address, name, log-format and record");
  EXPECT_EQ(faultOf("port = 65536"), ":1:8: error: port needs a whole number from 0 to 65535");
  EXPECT_EQ(faultOf("port = 1.5"), ":1:8: error: port needs a whole number from 0 to 65535");
  EXPECT_EQ(faultOf("max-players = 257"), ":1:15: error: max-players needs a whole number from 1 to 256");
  EXPECT_EQ(faultOf("name = 3"), ":1:8: error: name needs a text in quotes");
  EXPECT_EQ(faultOf("name = \"\\u0007\""),
            ":1:8: error: name needs a text of at most 32 bytes without control characters");
  EXPECT_EQ(faultOf("levels = \"a\""), ":1:10: error: levels needs a list of files: [\"a.level\", \"b.level\"]");
  EXPECT_EQ(faultOf("levels = [1]"), ":1:11: error: levels needs a text in quotes");
  EXPECT_EQ(faultOf("record = true"), ":1:10: error: record needs a text in quotes");
  EXPECT_EQ(faultOf("log-format = \"xml\""), ":1:14: error: log-format needs \"text\" or \"json\"");
  EXPECT_EQ(faultOf("port = ").substr(0, 13), ":1:8: error: ");
}

TEST_F(OptionsTest, FaultsAreOneLine) {
  for (const std::vector<const char*>& arguments : {std::vector<const char*>{"--colour"},
                                                    {"--port", "65536"},
                                                    {"--port", "x"},
                                                    {"--max-players", "0"},
                                                    {"--name", "a\nb"},
                                                    {"--log-format", "xml"},
                                                    {"--config", "/no/such/file"},
                                                    {"--port"}}) {
    const std::string what = fault([&] { read(arguments); });
    EXPECT_EQ(what.substr(0, 2), "2 ") << what;
    EXPECT_EQ(what.find('\n'), std::string::npos) << what;
  }
}

TEST_F(OptionsTest, LevelsAreRefusedWithAllTheirFaults) {
  const std::string good = write("good.level", farGoalText());
  const std::string bad = write("bad.level", "HEXAHEDRON\n0 0 0 x\n");
  const std::string worse = write("worse.level", "CUBE\n");
  EXPECT_EQ(loadLevelFiles({good, good}).levels.size(), 2u);
  const std::string what = fault([&] { loadLevelFiles({good, bad, worse}); });
  EXPECT_TRUE(what.starts_with("3 " + bad + ":2:7: error: ")) << what;
  EXPECT_NE(what.find("\n" + worse + ":1:1: error: "), std::string::npos) << what;
  EXPECT_EQ(fault([&] { loadLevelFiles({"/no/such.level"}); }),
            "2 cannot read the level '/no/such.level': No such file or directory; name an existing level file");
}

}  // namespace
}  // namespace platon
