#include "server/app/config_file.h"

#include <gtest/gtest.h>

#include "protocol/program_error.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace platon {
namespace {

class ConfigFileTest : public testing::Test {
 protected:
  ServerOptions read(const std::string& text, ServerOptions options = {}) const {
    writeText(file_, text);
    readConfigFile(file_, options);
    return options;
  }

  // The error message after the file's name.
  std::string errorOf(const std::string& text) const {
    try {
      read(text);
      return "none";
    } catch (const ProgramError& error) {
      EXPECT_EQ(error.exitCode(), ProgramError::kUsage);
      const std::string what = error.what();
      return what.starts_with(file_) ? what.substr(file_.size()) : what;
    }
  }

  const TemporaryFolder folder_;
  const std::string file_ = folder_ / "server.toml";
};

TEST_F(ConfigFileTest, ReadsEveryKey) {
  const ServerOptions expected{
      {folder_ / "a.level", "/b.level"}, "127.0.0.1", 1234, 5, 6, "Ours", LogFormat::kJson, folder_ / "games"};
  EXPECT_EQ(read("levels = [\"a.level\", \"/b.level\"]\nport = 1234\nmax-players = 5\nmax-per-address = 6\n"
                 "bind = \"127.0.0.1\"\nname = \"Ours\"\nlog-format = \"json\"\nrecord = \"games\"\n"),
            expected);
}

TEST_F(ConfigFileTest, KeysThatAreMissingKeepTheirValues) {
  ServerOptions before;
  before.port = 1;
  before.name = "Before";
  ServerOptions after = before;
  after.port = 2;
  EXPECT_EQ(read("port = 2\n", before), after);
  EXPECT_EQ(read("", before), before);
}

TEST_F(ConfigFileTest, AnEmptyRecordMeansNoRecordings) { EXPECT_EQ(read("record = \"\"\n").record, ""); }

TEST_F(ConfigFileTest, TextIsTheDefaultAndANamedLogFormat) {
  ServerOptions json;
  json.logFormat = LogFormat::kJson;
  EXPECT_EQ(read("log-format = \"text\"\n", json).logFormat, LogFormat::kText);
}

TEST_F(ConfigFileTest, ErrorsHaveALineAndAColumn) {
  EXPECT_EQ(errorOf("port = 1\n  colour = 2\n"),
            ":2:3: error: colour is not a key of the configuration; the keys are levels, bind, port, max-players, "
            "max-per-address, name, log-format and record");
  EXPECT_EQ(errorOf("port = 65536"), ":1:8: error: port must be a whole number from 0 to 65535");
  EXPECT_EQ(errorOf("port = 1.5"), ":1:8: error: port must be a whole number from 0 to 65535");
  EXPECT_EQ(errorOf("max-players = 0"), ":1:15: error: max-players must be a whole number from 1 to 256");
  EXPECT_EQ(errorOf("max-players = 257"), ":1:15: error: max-players must be a whole number from 1 to 256");
  EXPECT_EQ(errorOf("max-per-address = 4001"), ":1:19: error: max-per-address must be a whole number from 1 to 4000");
  EXPECT_EQ(errorOf("name = 3"), ":1:8: error: name must be a string in quotes");
  EXPECT_EQ(errorOf("name = \"\\u0007\""),
            ":1:8: error: name must be a string of at most 32 bytes without control characters");
  EXPECT_EQ(errorOf("levels = \"a\""), ":1:10: error: levels must be a list of files: [\"a.level\", \"b.level\"]");
  EXPECT_EQ(errorOf("levels = [1]"), ":1:11: error: levels must be a string in quotes");
  EXPECT_EQ(errorOf("record = true"), ":1:10: error: record must be a string in quotes");
  EXPECT_EQ(errorOf("log-format = \"xml\""), ":1:14: error: log-format must be \"text\" or \"json\"");
  EXPECT_EQ(errorOf("port = ").substr(0, 13), ":1:8: error: ");
}

TEST_F(ConfigFileTest, AMissingFileIsNamed) {
  ServerOptions options;
  try {
    readConfigFile("/no/such/file", options);
    FAIL();
  } catch (const ProgramError& error) {
    const std::string what = error.what();
    EXPECT_TRUE(what.starts_with("/no/such/file: error: ")) << what;
    EXPECT_TRUE(what.ends_with("; name an existing file after --config")) << what;
  }
}

}  // namespace
}  // namespace platon
