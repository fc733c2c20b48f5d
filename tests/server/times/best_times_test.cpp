#include "server/times/best_times.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <thread>

#include <gtest/gtest.h>

#include "platon/game/game.h"
#include "protocol/hash_text.h"
#include "protocol/limits.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/wait_until.h"

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
       "1:1: a line must begin with the hash of a level, 16 digits 0 to 9 and a to f"},
      {"123456789abcdef 6 743 2026-12-01T18:00:00Z Ann",
       "1:1: a line must begin with the hash of a level, 16 digits 0 to 9 and a to f"},
      {"0123456789abcdef 06 743 2026-12-01T18:00:00Z Ann",
       "1:18: the hash must be followed by the version of the rules, a whole number"},
      {"0123456789abcdef -6 743 2026-12-01T18:00:00Z Ann",
       "1:18: the hash must be followed by the version of the rules, a whole number"},
      {"0123456789abcdef 6 0 2026-12-01T18:00:00Z Ann",
       "1:20: the version must be followed by the ticks to the goal, 1 to 5184000"},
      {"0123456789abcdef " + std::to_string(kRulesVersion) + " 5184001 2026-12-01T18:00:00Z Ann",
       "1:20: the version must be followed by the ticks to the goal, 1 to 5184000"},
      {"0123456789abcdef 6 4294967296 2026-12-01T18:00:00Z Ann",
       "1:20: the version must be followed by the ticks to the goal, 1 to 5184000"},
      {"0123456789abcdef 6 743 2026-12-01 Ann",
       "1:24: the ticks must be followed by the date in UTC, such as 2026-12-01T18:00:00Z"},
      {"0123456789abcdef 6 743 2026-12-01T18:00:00Z",
       "1:44: the date must be followed by the name of the player, at most 32 bytes of text"},
      {"0123456789abcdef 6 743 2026-12-01T18:00:00Z a\x01",
       "1:45: the date must be followed by the name of the player, at most 32 bytes of text"},
      {"0123456789abcdef 6 743 2026-12-01T18:00:00Z \u200b",
       "1:45: the date must be followed by the name of the player, at most 32 bytes of text"},
      {"0123456789abcdef 6 743 2026-12-01T18:00:00Z " + std::string(kMaxNameBytes + 1, 'x'),
       "1:45: the date must be followed by the name of the player, at most 32 bytes of text"}};
  for (const auto& [text, error] : cases) EXPECT_EQ(errorsOf(text), std::vector{error + remedy}) << text;
  EXPECT_EQ(errorsOf(kLine + "\n" + kLine),
            std::vector<std::string>{"3:1: two times for this level and these rules; remove one of them"});
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
}

using namespace std::chrono_literals;

constexpr FileWriter::Time kNow{1h};

UtcTime clockOf() { return kDate; }

BestTimes timesIn(const std::string& path) {
  auto read = readBestTimes(path);
  const auto* errors = std::get_if<std::vector<std::string>>(&read);
  EXPECT_EQ(errors, nullptr) << errors->front();
  return errors ? BestTimes() : std::get<BestTimes>(std::move(read));
}

class BestTimeStoreTest : public testing::Test {
 protected:
  BestTimeStore open() { return {clockOf, path_, timesIn(path_)}; }

  const TemporaryFolder folder_;
  const std::string path_ = folder_ / "best_times";
};

TEST_F(BestTimeStoreTest, WithoutAFileTimesEndWithTheStore) {
  BestTimeStore store(clockOf);
  EXPECT_EQ(store.best(5), std::nullopt);
  EXPECT_TRUE(store.offer(5, {100, "Ann"}));
  EXPECT_FALSE(store.offer(5, {100, "Ben"}));
  EXPECT_EQ(store.best(5), (BestTime{100, "Ann"}));
  EXPECT_EQ(store.poll(kNow), std::nullopt);
  EXPECT_EQ(store.finish(), std::nullopt);
}

TEST_F(BestTimeStoreTest, ATimeThatEndsWithTheServerIsNotInTheFileNorHidesOneThatLasts) {
  {
    BestTimeStore store = open();
    EXPECT_TRUE(store.offer(5, {100, "Ben"}, false));
    EXPECT_FALSE(store.pending());
    EXPECT_FALSE(store.offer(5, {110, "Ann"}, true));
    EXPECT_EQ(store.best(5), (BestTime{100, "Ben"}));
    EXPECT_EQ(store.finish(), std::nullopt);
  }
  EXPECT_EQ(open().best(5), (BestTime{110, "Ann"}));
}

TEST_F(BestTimeStoreTest, AFileKeepsTheTimesForTheNextStart) {
  {
    BestTimeStore store = open();
    EXPECT_TRUE(store.offer(5, {100, "Ann"}));
    EXPECT_TRUE(store.offer(6, {90, "Ben"}));
    EXPECT_TRUE(store.pending());
    EXPECT_EQ(store.finish(), std::nullopt);
    EXPECT_FALSE(store.pending());
  }
  BestTimeStore store = open();
  EXPECT_EQ(store.best(5), (BestTime{100, "Ann"}));
  EXPECT_EQ(store.best(6), (BestTime{90, "Ben"}));
  EXPECT_EQ(timesIn(path_).find({5, kRulesVersion})->date, kDate);
}

TEST_F(BestTimeStoreTest, TimesOfOtherRulesStayInTheFileAndDoNotCount) {
  const std::string other = "0000000000000005 4294967295 1 2026-01-01T00:00:00Z Cid\n";
  writeText(path_, other);
  BestTimeStore store = open();
  EXPECT_EQ(store.best(5), std::nullopt);
  EXPECT_TRUE(store.offer(5, {100, "Ann"}));
  EXPECT_EQ(store.finish(), std::nullopt);
  EXPECT_NE(readText(path_).find(other), std::string::npos);
  EXPECT_EQ(timesIn(path_).size(), 2u);
}

TEST_F(BestTimeStoreTest, TwoServersShareAFile) {
  BestTimeStore a = open();
  BestTimeStore b = open();
  a.offer(1, {10, "a"});
  a.offer(2, {10, "a"});
  EXPECT_EQ(a.finish(), std::nullopt);
  b.offer(2, {9, "b"});
  b.offer(3, {9, "b"});
  EXPECT_EQ(b.finish(), std::nullopt);
  a.offer(3, {8, "a"});
  EXPECT_EQ(a.finish(), std::nullopt);
  const BestTimes times = timesIn(path_);
  EXPECT_EQ(times.find({1, kRulesVersion})->time, (BestTime{10, "a"}));
  EXPECT_EQ(times.find({2, kRulesVersion})->time, (BestTime{9, "b"}));
  EXPECT_EQ(times.find({3, kRulesVersion})->time, (BestTime{8, "a"}));
}

// Each reads the file, adds its time and replaces it.
TEST_F(BestTimeStoreTest, ServersThatWriteAtOnceLoseNoTime) {
  constexpr std::uint64_t kLevels = 40;
  const auto serve = [this](std::uint64_t first) {
    for (std::uint64_t level = first; level < kLevels; level += 2) {
      BestTimes own;
      own.offer({level, kRulesVersion}, {{10, "Ann"}, kDate});
      while (!addBestTimes(path_, own.text()).empty()) continue;  // the other may hold the lock for long
    }
  };
  {
    const std::jthread even(serve, 0);
    const std::jthread odd(serve, 1);
  }
  EXPECT_EQ(timesIn(path_).size(), kLevels);
}

// What was removed from the file by hand does not come back with the next time.
TEST_F(BestTimeStoreTest, OnlyNewTimesAreAddedToTheFile) {
  BestTimeStore store = open();
  store.offer(1, {10, "Ann"});
  EXPECT_EQ(store.finish(), std::nullopt);
  writeText(path_, "");
  store.offer(2, {10, "Ann"});
  EXPECT_EQ(store.finish(), std::nullopt);
  EXPECT_EQ(timesIn(path_).size(), 1u);
}

TEST_F(BestTimeStoreTest, AFileThatWasDamagedMeanwhileIsNotChanged) {
  BestTimeStore store = open();
  writeText(path_, "damaged\n");
  store.offer(1, {10, "Ann"});
  const auto fault = store.finish();
  ASSERT_TRUE(fault);
  EXPECT_TRUE(fault->starts_with(path_ + ":1:1: error: ")) << *fault;
  EXPECT_EQ(readText(path_), "damaged\n");
  EXPECT_TRUE(store.pending());
  writeText(path_, "");
  EXPECT_EQ(store.finish(), std::nullopt);
  EXPECT_EQ(timesIn(path_).size(), 1u);
}

TEST_F(BestTimeStoreTest, AFileThatCannotBeWrittenIsReportedAndTriedAgain) {
  std::filesystem::create_directory(folder_ / "later");
  const std::string path = folder_ / "later/best_times";
  BestTimeStore store{clockOf, path, BestTimes()};
  std::filesystem::remove(folder_ / "later");
  store.offer(1, {10, "Ann"});
  std::optional<std::string> fault;
  ASSERT_TRUE(waitUntil([&] { return (fault = store.poll(kNow)).has_value(); }));
  EXPECT_EQ(fault, "No such file or directory; name a file that can be read and written, in a folder that exists");
  std::filesystem::create_directory(folder_ / "later");
  EXPECT_EQ(store.finish(), std::nullopt);
  EXPECT_EQ(timesIn(path).size(), 1u);
}

TEST_F(BestTimeStoreTest, AMissingFileHasNoTimesButNeedsItsFolder) {
  EXPECT_TRUE(timesIn(path_).empty());
  const auto read = readBestTimes(folder_ / "no/best_times");
  ASSERT_TRUE(std::holds_alternative<std::vector<std::string>>(read));
  EXPECT_NE(std::get<std::vector<std::string>>(read).front().find("in a folder that exists"), std::string::npos);
}

TEST_F(BestTimeStoreTest, AFileThatIsTooLargeIsRefused) {
  writeText(path_, std::string(BestTimes::kMaxBytes + 1, '\n'));
  EXPECT_EQ(std::get<std::vector<std::string>>(readBestTimes(path_)),
            std::vector{path_ + ": error: it has more than 1048576 bytes; remove lines that you do not need"});
}

TEST_F(BestTimeStoreTest, ADamagedFileIsRefusedWithThePlaceOfTheError) {
  writeText(path_, "\n0000000000000005 6 0 2026-01-01T00:00:00Z Cid\n");
  const auto read = readBestTimes(path_);
  ASSERT_TRUE(std::holds_alternative<std::vector<std::string>>(read));
  EXPECT_TRUE(std::get<std::vector<std::string>>(read).front().starts_with(path_ + ":2:20: error: "));
}

}  // namespace
}  // namespace platon::best_times_test
