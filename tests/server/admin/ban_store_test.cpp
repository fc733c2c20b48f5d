#include "server/admin/ban_store.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/wait_until.h"

namespace platon::ban_store_test {
namespace {

const UtcTime kNow = *parseUtcTime("2026-11-22T12:00:00Z");
constexpr FileWriter::Time kMoment{std::chrono::hours(1)};

AddressRange range(const std::string& text) { return std::get<AddressRange>(AddressRange::parse(text)); }
Ban banOf(const std::string& text) { return {range(text), std::nullopt, "x"}; }

class BanStoreTest : public testing::Test {
 protected:
  BanStore open(const std::string& text) {
    writeText(path_, text);
    return BanStore(path_, std::get<BanList>(readBanFile(path_)));
  }

  // Polls until the file has this content.
  bool writes(BanStore& store, const std::string& text) const {
    return stepUntil([&] { EXPECT_EQ(store.poll(kMoment), std::nullopt); }, [&] { return readText(path_) == text; });
  }

  const TemporaryFolder folder_;
  const std::string path_ = folder_ / "bans.txt";
};

TEST_F(BanStoreTest, WithoutAFileItKeepsBansInMemory) {
  BanStore store;
  EXPECT_FALSE(store.hasFile());
  EXPECT_EQ(store.add(banOf("192.0.2.7"), kNow), std::nullopt);
  EXPECT_TRUE(store.list().find(range("192.0.2.7")));
  EXPECT_EQ(store.replace(BanList()), std::nullopt);  // a reload has no file to read
  EXPECT_EQ(store.list().size(), 1u);
  EXPECT_EQ(store.remove(range("192.0.2.7"), kNow), std::nullopt);
  EXPECT_EQ(store.list().size(), 0u);
}

TEST_F(BanStoreTest, WritesAChangeAndKeepsComments) {
  BanStore store = open("# mine\n192.0.2.7\n");
  EXPECT_EQ(store.add(banOf("192.0.2.8"), kNow), std::nullopt);
  EXPECT_TRUE(writes(store, "# mine\n192.0.2.7\n192.0.2.8 x\n"));
  EXPECT_EQ(store.remove(range("192.0.2.7"), kNow), std::nullopt);
  EXPECT_TRUE(writes(store, "# mine\n192.0.2.8 x\n"));
}

TEST_F(BanStoreTest, AChangeDropsTheBansThatHaveEnded) {
  BanStore store = open("192.0.2.7 until 2026-11-01\n192.0.2.9\n");
  EXPECT_EQ(store.add(banOf("192.0.2.8"), kNow), std::nullopt);
  EXPECT_TRUE(writes(store, "192.0.2.9\n192.0.2.8 x\n"));
}

TEST_F(BanStoreTest, KeepsWhatWasEditedMeanwhile) {
  BanStore store = open("192.0.2.7\n");
  writeText(path_, "192.0.2.7\n203.0.113.0/24 edited\n");
  EXPECT_EQ(store.add(banOf("192.0.2.8"), kNow), std::nullopt);
  EXPECT_TRUE(store.list().find(range("203.0.113.0/24")));
  EXPECT_TRUE(writes(store, "192.0.2.7\n203.0.113.0/24 edited\n192.0.2.8 x\n"));
}

TEST_F(BanStoreTest, ChangesNothingWhileTheFileHasAnError) {
  BanStore store = open("192.0.2.7\n");
  writeText(path_, "192.0.2.7\nAnn\n");
  const auto error = store.add(banOf("192.0.2.8"), kNow);
  ASSERT_TRUE(error);
  EXPECT_EQ(error->what, path_ +
                             ":2:1: error: 'Ann' is not an address or a range of addresses, such as 192.0.2.7 or "
                             "2001:db8::/32; nothing has changed: correct the file first");
  EXPECT_TRUE(store.remove(range("192.0.2.7"), kNow));
  EXPECT_EQ(store.list().size(), 1u);
  EXPECT_EQ(readText(path_), "192.0.2.7\nAnn\n");
}

TEST_F(BanStoreTest, ABanThatCouldNotBeWrittenIsWrittenWithTheNextOne) {
  BanStore store = open("");
  std::filesystem::remove(path_);
  std::filesystem::create_directory(path_);
  const auto error = store.add(banOf("192.0.2.7"), kNow);
  EXPECT_TRUE(error);  // cannot be read
  std::filesystem::remove(path_);
  writeText(path_, "");
  EXPECT_EQ(store.add(banOf("192.0.2.7"), kNow), std::nullopt);
  EXPECT_EQ(store.add(banOf("192.0.2.8"), kNow), std::nullopt);  // perhaps before the first is in the file
  EXPECT_TRUE(writes(store, "192.0.2.7 x\n192.0.2.8 x\n"));
}

TEST_F(BanStoreTest, ABanThatCouldNotBeWrittenIsTriedAgain) {
  BanStore store = open("");
  EXPECT_EQ(store.add(banOf("192.0.2.7"), kNow), std::nullopt);
  std::filesystem::remove(path_);
  std::filesystem::create_directory(path_);
  std::optional<std::string> fault;
  EXPECT_TRUE(stepUntil([&] { fault = store.poll(kMoment); }, [&] { return fault.has_value(); }));
  EXPECT_TRUE(store.finish());
  std::filesystem::remove(path_);
  const auto step = [&] { EXPECT_EQ(store.poll(kMoment + FileWriter::kRetryInterval), std::nullopt); };
  EXPECT_TRUE(stepUntil(step, [&] { return std::filesystem::is_regular_file(path_); }));
  EXPECT_EQ(store.finish(), std::nullopt);
  EXPECT_EQ(readText(path_), "192.0.2.7 x\n");
}

TEST_F(BanStoreTest, SaysWhyThereIsNothingToRemove) {
  BanStore store = open("192.0.2.0/24\n");
  const auto errorOf = [&](const std::string& text) { return store.remove(range(text), kNow).value().what; };
  EXPECT_EQ(errorOf("192.0.2.7"), "there is no ban of 192.0.2.7; it is part of 192.0.2.0/24");
  EXPECT_EQ(errorOf("192.0.0.0/16"), "there is no ban of 192.0.0.0/16; the command bans lists all");
  EXPECT_EQ(errorOf("198.51.100.1"), "there is no ban of 198.51.100.1; the command bans lists all");
}

TEST_F(BanStoreTest, AReloadTakesOverTheFile) {
  BanStore store = open("192.0.2.7\n");
  writeText(path_, "192.0.2.8\n");
  EXPECT_EQ(store.replace(std::get<BanList>(readBanFile(path_))), std::nullopt);
  EXPECT_TRUE(store.list().find(range("192.0.2.8")));
  EXPECT_FALSE(store.list().find(range("192.0.2.7")));
}

// The file that was read does not hold the change yet.
TEST_F(BanStoreTest, AReloadDoesNotUndoAChangeThatWaitsToBeWritten) {
  BanStore store = open("");
  const BanList old = std::get<BanList>(readBanFile(path_));
  EXPECT_EQ(store.add(banOf("192.0.2.7"), kNow), std::nullopt);
  const auto error = store.replace(old);
  ASSERT_TRUE(error);
  EXPECT_EQ(error->what, path_ +
                             ": error: the last change of the bans is not written to this file yet, and will replace "
                             "what is in it; reload again when it is written");
  EXPECT_EQ(store.list().size(), 1u);
  EXPECT_TRUE(writes(store, "192.0.2.7 x\n"));
  EXPECT_TRUE(stepUntil([&] { store.poll(kMoment); }, [&] { return store.replace(BanList()) == std::nullopt; }));
  EXPECT_EQ(store.list().size(), 0u);
}

TEST_F(BanStoreTest, ReportsWhatIsWrongWithAFile) {
  using Lines = std::vector<std::string>;
  EXPECT_EQ(std::get<Lines>(readBanFile(path_)),
            Lines{path_ + ": error: No such file or directory; name a readable ban file; it may be empty"});
  writeText(path_, "a\nb\n");
  EXPECT_EQ(std::get<Lines>(readBanFile(path_)).size(), 2u);
}

TEST_F(BanStoreTest, DoesNotGrowAFileBeyondWhatItReads) {
  BanStore store = open("#" + std::string(BanList::kMaxBytes - 100, 'x') + "\n");
  const auto error = store.add(banOf("192.0.2.7"), kNow);
  ASSERT_TRUE(error);
  EXPECT_EQ(error->what, "the ban file is full: remove bans from it");
  EXPECT_EQ(store.list().size(), 0u);
}

}  // namespace
}  // namespace platon::ban_store_test
