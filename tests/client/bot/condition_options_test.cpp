#include "client/bot/condition_options.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "protocol/program_error.h"

namespace platon::condition_options_test {
namespace {

LinkQuality read(const std::vector<std::string>& words) {
  ProgramOptions program("bots", "");
  LinkQuality quality;
  addConditionOptions(program, quality);
  std::vector<const char*> arguments{"bots"};
  for (const std::string& word : words) arguments.push_back(word.c_str());
  program.read(static_cast<int>(arguments.size()), arguments.data());
  return quality;
}

// The error message; empty if the arguments are accepted.
std::string refusal(const std::vector<std::string>& words) {
  try {
    read(words);
    return "";
  } catch (const ProgramError& error) {
    return error.what();
  }
}

TEST(ConditionOptions, DefaultToPerfectConditions) { EXPECT_TRUE(read({}).perfect()); }

struct Case {
  std::string option;
  double LinkQuality::*field;
  double max;
};

const std::vector<Case> kCases = {{"--loss", &LinkQuality::lossPercent, 100},
                                  {"--burst-loss", &LinkQuality::burstLossPercent, 100},
                                  {"--delay", &LinkQuality::delayMs, 10000},
                                  {"--jitter", &LinkQuality::jitterMs, 10000},
                                  {"--duplicate", &LinkQuality::duplicatePercent, 100},
                                  {"--reorder", &LinkQuality::reorderPercent, 100},
                                  {"--rate", &LinkQuality::kilobytesPerSecond, 1000000},
                                  {"--corrupt", &LinkQuality::corruptPercent, 100}};

TEST(ConditionOptions, EachSetsItsFieldOnly) {
  for (const Case& one : kCases) {
    const LinkQuality quality = read({one.option, "12.5"});
    for (const Case& other : kCases) {
      EXPECT_EQ(quality.*other.field, one.option == other.option ? 12.5 : 0) << one.option << " in " << other.option;
    }
    EXPECT_FALSE(quality.perfect()) << one.option;
    EXPECT_TRUE(read({one.option, "0"}).perfect()) << one.option;
  }
}

TEST(ConditionOptions, RefuseValuesOutOfRange) {
  for (const Case& one : kCases) {
    const auto max = std::to_string(static_cast<int>(one.max));
    EXPECT_EQ(refusal({one.option, max}), "") << one.option;
    for (const std::string& value : {std::string("-0.1"), max + ".1", std::string("nan"), std::string("much")}) {
      std::string expected = one.option;
      expected.append(": '")
          .append(value)
          .append("' is not a number from 0 to ")
          .append(max)
          .append(" (see bots --help)");
      EXPECT_EQ(refusal({one.option, value}), expected);
    }
  }
}

TEST(ConditionOptions, BurstLengthNeedsBurstLoss) {
  EXPECT_EQ(read({"--burst-loss", "3"}).burstLength, 4);
  EXPECT_EQ(read({"--burst-length", "7.5", "--burst-loss", "3"}).burstLength, 7.5);
  EXPECT_EQ(refusal({"--burst-loss", "3", "--burst-length", "0.9"}),
            "--burst-length: '0.9' is not a number from 1 to 10000 (see bots --help)");
  EXPECT_EQ(refusal({"--burst-length", "7.5"}), "--burst-length requires --burst-loss (see bots --help)");
}

TEST(ConditionOptions, HaveTheirOwnGroupInTheHelp) {
  ProgramOptions program("bots", "");
  LinkQuality quality;
  addConditionOptions(program, quality);
  const std::string help = program.help();
  const std::size_t group = help.find("Simulated network conditions, each way:");
  ASSERT_NE(group, std::string::npos) << help;
  for (const Case& one : kCases) EXPECT_GT(help.find(one.option + " "), group) << help;
}

}  // namespace
}  // namespace platon::condition_options_test
