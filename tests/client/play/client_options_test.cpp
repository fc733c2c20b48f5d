#include "client/play/client_options.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "protocol/program_error.h"

namespace platon {
namespace {

std::optional<ClientOptions> read(std::vector<const char*> arguments) {
  arguments.insert(arguments.begin(), "platon-client");
  return readClientOptions(static_cast<int>(arguments.size()), arguments.data());
}

// The exit code and the sentence.
std::string fault(const std::vector<const char*>& arguments) {
  try {
    read(arguments);
    return "none";
  } catch (const ProgramError& error) {
    return std::to_string(error.exitCode()) + " " + error.what();
  }
}

TEST(ClientOptions, WithoutAnyItPlaysOnAServerOfItsOwnOverAPerfectLine) {
  const auto options = read({});
  ASSERT_TRUE(options);
  EXPECT_EQ(options->server, std::nullopt);
  EXPECT_EQ(options->seconds, std::nullopt);
  EXPECT_FALSE(options->demo || options->offscreen);
  EXPECT_TRUE(options->line.perfect());
  EXPECT_EQ(options->lineSeed, 1u);
}

TEST(ClientOptions, TakesALineAndItsSeed) {
  const auto options = read({"example.org:7800", "--loss", "2", "--rate", "16", "--line-seed", "18446744073709551615"});
  ASSERT_TRUE(options);
  ASSERT_TRUE(options->server);
  EXPECT_EQ(options->server->text(), "example.org:7800");
  EXPECT_EQ(options->line.lossPercent, 2);
  EXPECT_EQ(options->line.kilobytesPerSecond, 16);
  EXPECT_EQ(options->lineSeed, 18446744073709551615u);
}

TEST(ClientOptions, RefusesALineThatThereIsNot) {
  EXPECT_EQ(fault({"--corrupt", "101"}), "2 --corrupt: '101' is no number from 0 to 100 (see platon-client --help)");
  EXPECT_EQ(fault({"--burst-length", "3"}), "2 --burst-length requires --burst-loss (see platon-client --help)");
  EXPECT_EQ(fault({"--line-seed", "any"}).substr(0, 2), "2 ");
}

TEST(ClientOptions, ListsTheLineInAGroupOfItsOwn) {
  testing::internal::CaptureStdout();
  EXPECT_EQ(read({"--help"}), std::nullopt);
  const std::string help = testing::internal::GetCapturedStdout();
  const std::size_t group = help.find("\nSimulated line:\n");
  ASSERT_NE(group, std::string::npos) << help;
  EXPECT_LT(help.find("--demo"), group);
  EXPECT_GT(help.find("--burst-loss"), group);
  EXPECT_GT(help.find("--line-seed"), group);
}

}  // namespace
}  // namespace platon
