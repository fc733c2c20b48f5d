#include "protocol/program_options.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "protocol/program_error.h"

namespace platon::program_options_test {
namespace {

struct Values {
  std::string text;
  std::vector<std::string> files;
  int count = 3;
  double seconds = 1;
  std::optional<std::uint64_t> seed;
  bool json = false;
  int colour = 7;
};

class ProgramOptionsTest : public testing::Test {
 protected:
  ProgramOptionsTest() {
    program_.add("FILE", values_.files, "Files");
    auto text = program_.add("-t,--text", values_.text, "A text").placeholder("TEXT").group("Words");
    program_.add("--count", values_.count, "A count").range(1, 5).showDefault();
    program_.add("--seconds", values_.seconds, "A duration").range(0.5, 2.0);
    program_.add("--seed", values_.seed, "A seed").needs(text);
    program_.addFlag("--json", values_.json, "As JSON").excludes(text);
    program_.addWord("--colour", values_.colour, {{"RED", 0}, {"BLUE", 1}}, "A colour");
  }

  bool read(std::vector<const char*> words) {
    words.insert(words.begin(), "tool");
    return program_.read(static_cast<int>(words.size()), words.data());
  }

  // The error message; empty if the words are accepted.
  std::string refusal(const std::vector<const char*>& words) {
    try {
      read(words);
      return "";
    } catch (const ProgramError& error) {
      EXPECT_EQ(error.exitCode(), ProgramError::kUsage);
      return error.what();
    }
  }

  Values values_;
  ProgramOptions program_{"tool", "What the tool does."};
};

TEST_F(ProgramOptionsTest, WhatIsNotGivenStaysAsItIs) {
  EXPECT_TRUE(read({}));
  EXPECT_EQ(values_.count, 3);
  EXPECT_EQ(values_.seed, std::nullopt);
  EXPECT_FALSE(program_.given("--count"));
}

TEST_F(ProgramOptionsTest, ReadsValuesOfEachKind) {
  EXPECT_TRUE(read({"a", "-t", "word", "b", "--count=5", "--seconds", "0.5", "--seed", "18446744073709551615"}));
  EXPECT_EQ(values_.files, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(values_.text, "word");
  EXPECT_EQ(values_.count, 5);
  EXPECT_EQ(values_.seconds, 0.5);
  EXPECT_EQ(values_.seed, 18446744073709551615u);
  EXPECT_TRUE(program_.given("--count"));
  EXPECT_TRUE(program_.given("FILE"));
}

TEST_F(ProgramOptionsTest, AWordStandsForItsNumberInAnyCase) {
  EXPECT_TRUE(read({"--colour", "blue"}));
  EXPECT_EQ(values_.colour, 1);
  EXPECT_NE(refusal({"--colour", "green"}), "");
}

TEST_F(ProgramOptionsTest, RefusesNumbersOutOfRange) {
  EXPECT_NE(refusal({"--count", "0"}), "");
  EXPECT_NE(refusal({"--count", "6"}), "");
  for (const char* const seconds : {"0.4", "2.1", "nan", "much", ""}) {
    EXPECT_EQ(refusal({"--seconds", seconds}),
              "--seconds: '" + std::string(seconds) + "' is not a number from 0.5 to 2 (see tool --help)");
  }
}

TEST_F(ProgramOptionsTest, SaysWhichOptionsGoTogether) {
  EXPECT_EQ(refusal({"--seed", "1"}), "--seed requires --text (see tool --help)");
  EXPECT_EQ(refusal({"--json", "--text", "a"}), "--text excludes --json (see tool --help)");
}

TEST_F(ProgramOptionsTest, ARefusalIsOneLine) {
  try {
    program_.refuse("two\nlines");
  } catch (const ProgramError& error) {
    EXPECT_STREQ(error.what(), "two lines (see tool --help)");
  }
}

TEST_F(ProgramOptionsTest, PrintsHelpAndVersionInsteadOfReading) {
  testing::internal::CaptureStdout();
  EXPECT_FALSE(read({"--help"}));
  EXPECT_EQ(testing::internal::GetCapturedStdout(), program_.help());
  testing::internal::CaptureStdout();
  EXPECT_FALSE(read({"--version"}));
  EXPECT_EQ(testing::internal::GetCapturedStdout().rfind("tool ", 0), 0u);
  for (const char* const part : {"What the tool does.", "TEXT", "Words:", "=3", "[0.5 - 2]"}) {
    EXPECT_NE(program_.help().find(part), std::string::npos) << part << "\n" << program_.help();
  }
}

TEST(ProgramCommands, OneMustBeGiven) {
  ProgramOptions program("tool", "");
  bool json = false;
  const ProgramOptions draw = program.addCommand("draw", "Draws");
  program.addCommand("check", "Checks").addFlag("--json", json, "As JSON");
  const char* const alone[] = {"tool"};
  EXPECT_THROW(program.read(1, alone), ProgramError);
  const char* const words[] = {"tool", "check", "--json"};
  EXPECT_TRUE(program.read(3, words));
  EXPECT_TRUE(json);
  EXPECT_FALSE(draw.given());
}

TEST(ProgramCommands, AnUnknownOneIsNamed) {
  const auto refusalOf = [](const char* word) {
    ProgramOptions program("tool", "");
    program.addCommand("draw", "Draws");
    const char* const words[] = {"tool", word, "--json"};
    try {
      program.read(3, words);
      return std::string();
    } catch (const ProgramError& error) {
      return std::string(error.what());
    }
  };
  EXPECT_EQ(refusalOf("drew"), "'drew' is not a command (see tool --help)");
  EXPECT_EQ(refusalOf("--drew"), "'--drew' is not an option (see tool --help)");
}

TEST_F(ProgramOptionsTest, AnOptionMayTakeSeveralTexts) {
  std::vector<std::string> pair;
  program_.add("--pair", pair, "A pair").texts(1, 2);
  EXPECT_TRUE(read({"--pair", "a", "b", "file"}));
  EXPECT_EQ(pair, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(values_.files, std::vector<std::string>{"file"});
}

}  // namespace
}  // namespace platon::program_options_test
