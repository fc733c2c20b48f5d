#include "tests/sim/sim_options.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace platon::sim::sim_options_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

Options parsed(const std::vector<std::string>& arguments) {
  return Options(arguments, {"ticks", "seed", "trace"}, {"json"});
}

std::string refusal(const std::function<void()>& call) {
  try {
    call();
  } catch (const UsageError& reason) {
    return reason.what();
  }
  return "";
}

TEST(OptionsTest, SeparatesWordsFromOptions) {
  const Options options = parsed({"one", "--ticks", "5", "two", "--json", "--trace=a=b"});
  EXPECT_THAT(options.positionals(), ElementsAre("one", "two"));
  EXPECT_TRUE(options.has("json"));
  EXPECT_TRUE(options.has("ticks"));
  EXPECT_FALSE(options.has("seed"));
  EXPECT_EQ(options.number("ticks", 0, 0, 10), 5);
  EXPECT_EQ(options.text("trace", ""), "a=b");
  EXPECT_EQ(options.text("seed", "none"), "none");
  EXPECT_THAT(parsed({}).positionals(), IsEmpty());
}

TEST(OptionsTest, RefusesUnknownOptionsAndMissingValues) {
  EXPECT_EQ(refusal([] { parsed({"--tick", "5"}); }), "unknown option --tick (see platon-sim --help)");
  EXPECT_EQ(refusal([] { parsed({"--json=1"}); }), "unknown option --json=1 (see platon-sim --help)");
  EXPECT_EQ(refusal([] { parsed({"--ticks"}); }), "option --ticks needs a value");
}

TEST(OptionsTest, NumbersAreIntegersInRange) {
  const std::string range = "--ticks must be an integer from -5 to 10, not '";
  for (const char* wrong : {"11", "-6", "", "x", "1x", " 1", "1.0", "99999999999999999999"}) {
    EXPECT_EQ(refusal([&] { parsed({"--ticks", wrong}).number("ticks", 0, -5, 10); }), range + wrong + "'");
  }
  EXPECT_EQ(parsed({"--ticks", "-5"}).number("ticks", 0, -5, 10), -5);
  EXPECT_EQ(parsed({"--ticks", "10"}).number("ticks", 0, -5, 10), 10);
  EXPECT_EQ(parsed({}).number("ticks", 77, -5, 10), 77);
  EXPECT_EQ(parsed({}).seed(), 1u);
  EXPECT_EQ(parsed({"--seed", "9223372036854775807"}).seed(), 9223372036854775807u);
  EXPECT_NE(refusal([] { parsed({"--seed", "-1"}).seed(); }), "");
}

}  // namespace
}  // namespace platon::sim::sim_options_test
