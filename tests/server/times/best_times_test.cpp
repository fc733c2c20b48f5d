#include "server/times/best_times.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "protocol/hash_text.h"
#include "protocol/limits.h"

namespace platon::best_times_test {
namespace {

using std::chrono::seconds;

const UtcTime kDate = *parseUtcTime("2026-12-01T18:00:00Z");
const std::string kLine = "0123456789abcdef 6 743 2026-12-01T18:00:00Z Ann\n";

DatedTime timeOf(std::uint32_t ticks, const std::string& name = "Ann", int second = 0) {
  return {{ticks, name}, kDate + seconds(second)};
}

BestTimes read(const std::string& text) {
  auto parsed = BestTimes::parse(text);
  const auto* errors = std::get_if<std::vector<Diagnostic>>(&parsed);
  EXPECT_EQ(errors, nullptr) << errors->front().message;
  return errors ? BestTimes() : std::get<BestTimes>(std::move(parsed));
}

// The errors of a text, each as `line:column: message`.
std::vector<std::string> errorsOf(const std::string& text) {
  auto parsed = BestTimes::parse(text);
  std::vector<std::string> found;
  if (!std::holds_alternative<std::vector<Diagnostic>>(parsed)) return found;
  for (const Diagnostic& one : std::get<std::vector<Diagnostic>>(parsed)) {
    found.push_back(std::to_string(one.line) + ":" + std::to_string(one.column) + ": " + one.message);
  }
  return found;
}

TEST(BestTimes, ReadsWhatItHasWritten) {
  BestTimes times;
  times.offer({1, kRulesVersion}, timeOf(1));
  times.offer({UINT64_MAX, kRulesVersion}, timeOf(kMaxBestTicks, std::string(kMaxNameBytes, 'x'), 99));
  times.offer({1, 0}, timeOf(UINT32_MAX, "# Łukasz the 2nd"));
  times.offer({1, UINT32_MAX}, timeOf(7));
  EXPECT_EQ(times.size(), 4u);
  EXPECT_EQ(read(times.text()), times);
  EXPECT_TRUE(read(BestTimes().text()).empty());
}

TEST(BestTimes, ReadsALineByHand) {
  const BestTimes times = read("# a comment\n\n  " + kLine + "\t# another\n");
  ASSERT_EQ(times.size(), 1u);
  const DatedTime* best = times.find({0x0123456789abcdef, 6});
  ASSERT_TRUE(best);
  EXPECT_EQ(*best, timeOf(743));
  EXPECT_EQ(read(kLine.substr(0, kLine.size() - 1)), times) << "without the last line feed";
}

TEST(BestTimes, OnlyALesserTimeIsTaken) {
  BestTimes times;
  const PlayedLevel level{5, 6};
  EXPECT_EQ(times.find(level), nullptr);
  EXPECT_TRUE(times.offer(level, timeOf(100, "Ann")));
  EXPECT_FALSE(times.offer(level, timeOf(101, "Ben")));
  EXPECT_FALSE(times.offer(level, timeOf(100, "Ben"))) << "the first of two equal times stays";
  EXPECT_EQ(*times.find(level), timeOf(100, "Ann"));
  EXPECT_TRUE(times.offer(level, timeOf(99, "Ben", 7)));
  EXPECT_EQ(*times.find(level), timeOf(99, "Ben", 7));
}

TEST(BestTimes, TimesOfOtherRulesAndLevelsAreKeptButNotCompared) {
  BestTimes times;
  times.offer({5, 6}, timeOf(100));
  EXPECT_TRUE(times.offer({5, 7}, timeOf(200)));
  EXPECT_TRUE(times.offer({4, 6}, timeOf(300)));
  EXPECT_EQ(times.find({5, 6})->time.ticks, 100u);
  EXPECT_EQ(times.find({5, 7})->time.ticks, 200u);
  EXPECT_EQ(times.find({4, 6})->time.ticks, 300u);
}

TEST(BestTimes, MergingTakesTheLesserOfBoth) {
  BestTimes a, b;
  a.offer({1, 6}, timeOf(10, "a"));
  a.offer({2, 6}, timeOf(10, "a"));
  a.offer({3, 6}, timeOf(10, "a"));
  b.offer({2, 6}, timeOf(9, "b"));
  b.offer({3, 6}, timeOf(11, "b"));
  b.offer({4, 6}, timeOf(11, "b"));
  a.merge(b);
  std::string names;
  for (std::uint64_t level = 1; level <= 4; ++level) names += a.find({level, 6})->time.name;
  EXPECT_EQ(names, "abab");
}

TEST(BestTimes, TheOldestIsForgottenWhenThereAreTooMany) {
  BestTimes times;
  for (std::uint64_t level = 0; level < BestTimes::kMaxTimes; ++level) {
    times.offer({level, 6}, timeOf(10, std::string(kMaxNameBytes, 'x'), level == 77 ? 0 : 1));
  }
  EXPECT_TRUE(times.offer({1'000'000, 6}, timeOf(10, "new", 2)));
  EXPECT_EQ(times.size(), BestTimes::kMaxTimes);
  EXPECT_EQ(times.find({77, 6}), nullptr);
  EXPECT_TRUE(times.find({1'000'000, 6}));
  EXPECT_LE(times.text().size(), BestTimes::kMaxBytes);
  EXPECT_EQ(read(times.text()), times);
}

// Forgets the oldest times one by one: the law that those of a text, and of two that are merged, must agree with.
void forgetOneByOne(std::map<PlayedLevel, DatedTime>& times) {
  while (times.size() > BestTimes::kMaxTimes) {
    times.erase(std::min_element(times.begin(), times.end(),
                                 [](const auto& a, const auto& b) { return a.second.date < b.second.date; }));
  }
}

std::string linesOf(const std::map<PlayedLevel, DatedTime>& times) {
  std::string lines;
  for (const auto& [level, best] : times) {
    lines += hashText(level.hash) + " " + std::to_string(level.rules) + " " + std::to_string(best.time.ticks) + " " +
             formatUtcTime(best.date) + " " + best.time.name + "\n";
  }
  return lines;
}

TEST(BestTimes, OfManyTooManyThoseAreForgottenThatAreOldestOneByOne) {
  std::map<PlayedLevel, DatedTime> these, those;
  for (std::uint64_t level = 0; level < BestTimes::kMaxTimes + 300; ++level) {
    these[{level, 6}] = timeOf(10, "Ann", static_cast<int>(level * 7919 % 500));
    those[{level * 3, 6}] = timeOf(20, "Ben", static_cast<int>(level * 104'729 % 500));
  }
  BestTimes times = read(linesOf(these));
  const BestTimes others = read(linesOf(those));
  forgetOneByOne(these);
  EXPECT_EQ(times, read(linesOf(these)));
  EXPECT_EQ(times.size(), BestTimes::kMaxTimes);
  forgetOneByOne(those);
  EXPECT_EQ(others, read(linesOf(those)));
  times.merge(others);
  these.merge(those);
  forgetOneByOne(these);
  EXPECT_EQ(times, read(linesOf(these)));
}

TEST(BestTimes, EachErrorHasItsPlaceAndRemedy) {
  const std::string remedy = "; correct or remove the line";
  const std::pair<std::string, std::string> cases[] = {
      {"0123456789ABCDEF 6 743 2026-12-01T18:00:00Z Ann",
       "1:1: a line begins with the hash of a level, 16 digits 0 to 9 and a to f"},
      {"123456789abcdef 6 743 2026-12-01T18:00:00Z Ann",
       "1:1: a line begins with the hash of a level, 16 digits 0 to 9 and a to f"},
      {"0123456789abcdef 06 743 2026-12-01T18:00:00Z Ann",
       "1:18: after the hash must stand the version of the rules, a whole number"},
      {"0123456789abcdef -6 743 2026-12-01T18:00:00Z Ann",
       "1:18: after the hash must stand the version of the rules, a whole number"},
      {"0123456789abcdef 6 0 2026-12-01T18:00:00Z Ann",
       "1:20: after the rules must stand the ticks to the goal, 1 to 5184000"},
      {"0123456789abcdef " + std::to_string(kRulesVersion) + " 5184001 2026-12-01T18:00:00Z Ann",
       "1:20: after the rules must stand the ticks to the goal, 1 to 5184000"},
      {"0123456789abcdef 6 4294967296 2026-12-01T18:00:00Z Ann",
       "1:20: after the rules must stand the ticks to the goal, 1 to 5184000"},
      {"0123456789abcdef 6 743 2026-12-01 Ann",
       "1:24: after the ticks must stand the date in UTC, such as 2026-12-01T18:00:00Z"},
      {"0123456789abcdef 6 743 2026-12-01T18:00:00Z",
       "1:44: at the end must stand the name of the player, 1 to 32 visible bytes"},
      {"0123456789abcdef 6 743 2026-12-01T18:00:00Z a\x01",
       "1:45: at the end must stand the name of the player, 1 to 32 visible bytes"},
      {"0123456789abcdef 6 743 2026-12-01T18:00:00Z \u200b",
       "1:45: at the end must stand the name of the player, 1 to 32 visible bytes"},
      {"0123456789abcdef 6 743 2026-12-01T18:00:00Z " + std::string(kMaxNameBytes + 1, 'x'),
       "1:45: at the end must stand the name of the player, 1 to 32 visible bytes"}};
  for (const auto& [text, error] : cases) EXPECT_EQ(errorsOf(text), std::vector{error + remedy}) << text;
  EXPECT_EQ(errorsOf(kLine + "\n" + kLine),
            std::vector<std::string>{"3:1: a second time of this level and these rules; remove one of them"});
}

// A version that showed more of a name has written it.
TEST(BestTimes, OfANameThatIsReadStaysWhatCanBeSeen) {
  const BestTimes times = read("0123456789abcdef 6 743 2026-12-01T18:00:00Z A\u0301\u0302\u0303nn\n");
  EXPECT_EQ(times.find({0x0123456789abcdef, 6})->time.name, "Á\u0302nn");
}

TEST(BestTimes, ErrorsAreBounded) {
  std::string text;
  for (int i = 0; i < 1000; ++i) text += "x\n";
  const std::vector<std::string> errors = errorsOf(text);
  ASSERT_EQ(errors.size(), BestTimes::kMaxErrors + 1);
  EXPECT_EQ(errors.back(), "100:1: too many errors; fix these first");
  EXPECT_EQ(errorsOf(std::string(BestTimes::kMaxBytes + 1, '\n')),
            std::vector<std::string>{"1:1: the file has more than 1048576 bytes"});
}

}  // namespace
}  // namespace platon::best_times_test
