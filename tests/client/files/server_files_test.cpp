#include "client/files/server_files.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string>

#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace platon::server_files_test {
namespace {

namespace fs = std::filesystem;

const ServerAddress kServer{"play.example.org", 7777};
const SessionToken kToken{1, 2, 3, 0, 255};
const SessionToken kOther{9};

class SessionFileTest : public testing::Test {
 protected:
  std::size_t files() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }

  std::optional<SessionToken> kept(const ServerAddress& server = kServer) const {
    return SessionFile(folder_, server).token();
  }

  void keep(const SessionToken& token, const ServerAddress& server = kServer) const {
    SessionFile(folder_, server).keep(token);
  }

  const TemporaryFolder temporary_;
  const fs::path folder_ = temporary_ / "deep";
};

TEST_F(SessionFileTest, ReturnsTheStoredToken) {
  EXPECT_EQ(kept(), std::nullopt);
  keep(kToken);
  EXPECT_EQ(kept(), kToken);
  keep(kOther);
  EXPECT_EQ(kept(), kOther);
}

TEST_F(SessionFileTest, KeepsOneTokenPerServer) {
  keep(kToken);
  keep(kOther, {kServer.host, 7778});
  EXPECT_EQ(kept(), kToken);
  EXPECT_EQ(kept({kServer.host, 7778}), kOther);
  EXPECT_EQ(kept({"example.org", 7777}), std::nullopt);
}

TEST_F(SessionFileTest, ForgetRemovesTheFile) {
  keep(kToken);
  SessionFile file(folder_, kServer);
  file.forget();
  EXPECT_EQ(files(), 0u);
  file.keep(kOther);
  EXPECT_EQ(file.token(), std::nullopt);
  EXPECT_EQ(kept(), std::nullopt);
}

TEST_F(SessionFileTest, LeavesNoFileWithoutAToken) {
  SessionFile(folder_, kServer);
  EXPECT_EQ(files(), 0u);
}

TEST_F(SessionFileTest, ASecondObjectCannotUseTheFile) {
  std::optional<SessionFile> first(std::in_place, folder_, kServer);
  first->keep(kToken);
  SessionFile second(folder_, kServer);
  EXPECT_EQ(second.token(), std::nullopt);
  second.keep(kOther);
  second.forget();
  EXPECT_EQ(first->token(), kToken);
  first.reset();
  EXPECT_EQ(second.token(), std::nullopt) << "the second object never owned the file";
  EXPECT_EQ(kept(), kToken);
}

TEST_F(SessionFileTest, AfterForgetTheNextObjectOwnsANewFile) {
  SessionFile first(folder_, kServer);
  first.keep(kToken);
  first.forget();
  SessionFile second(folder_, kServer);
  second.keep(kOther);
  first.forget();
  EXPECT_EQ(second.token(), kOther);
  EXPECT_EQ(SessionFile(folder_, kServer).token(), std::nullopt);
}

TEST_F(SessionFileTest, IsReadableOnlyByItsOwner) {
  fs::create_directories(folder_);
  const fs::path path = folder_ / "play.example.org_7777";
  std::ofstream(path) << "x";
  fs::permissions(path, fs::perms(0644));
  keep(kToken);
  EXPECT_EQ(fs::status(path).permissions(), fs::perms(0600));
  fs::remove(path);
  keep(kToken);
  EXPECT_EQ(fs::status(path).permissions(), fs::perms(0600));
}

TEST_F(SessionFileTest, IgnoresAFileOfAnotherLength) {
  fs::create_directories(folder_);
  for (const std::size_t size : {0u, 1u, 15u, 17u, 4096u}) {
    std::ofstream(folder_ / "play.example.org_7777") << std::string(size, 'x');
    EXPECT_EQ(kept(), std::nullopt) << size;
  }
}

TEST_F(SessionFileTest, NoHostNameLeavesTheFolder) {
  for (const char* const host : {"..", "../..", "/etc/passwd", "a/b", "", "ü", "a%b", "a_b"}) {
    keep(kToken, {host, 1});
    EXPECT_EQ(kept({host, 1}), kToken) << host;
  }
  EXPECT_EQ(files(), 8u);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_.parent_path()), fs::directory_iterator()), 1);
}

TEST_F(SessionFileTest, DoesNotFollowSymbolicLinks) {
  fs::create_directories(folder_);
  const fs::path target = folder_.parent_path() / "target";
  std::ofstream(target) << "mine";
  fs::create_symlink(target, folder_ / "play.example.org_7777");
  keep(kToken);
  EXPECT_EQ(kept(), std::nullopt);
  EXPECT_EQ(fs::file_size(target), 4u);
}

TEST_F(SessionFileTest, WithoutAUsableFolderNothingIsStored) {
  SessionFile nowhere(fs::path(), kServer);
  nowhere.keep(kToken);
  EXPECT_EQ(nowhere.token(), std::nullopt);
  nowhere.forget();
  fs::create_directories(folder_.parent_path());
  std::ofstream(folder_) << "a file";
  keep(kToken);
  EXPECT_EQ(kept(), std::nullopt);
  keep(kToken, {std::string(1000, 'h'), 1});
}

const ServerAddress kOtherServer{"play.example.org", 7778};

std::shared_ptr<const Level> levelOf(const std::string& title, std::size_t comment = 0) {
  const std::string text =
      "# title: " + title + "\nHEXAHEDRON\n0 0 0 0\n1 0 0\n480\n%\n%\n%\n%\n%\n%\n#" + std::string(comment, 'x') + "\n";
  const LevelResult result = loadLevel(text);
  if (!result.level) throw std::logic_error("test level: " + result.diagnostics.front().message);
  return result.level;
}

class LevelCacheTest : public testing::Test {
 protected:
  std::size_t files() const {
    std::size_t count = 0;
    for (const auto& entry : fs::recursive_directory_iterator(folder_)) count += entry.is_regular_file() ? 1 : 0;
    return count;
  }
  // The only file.
  fs::path file() const {
    for (const auto& entry : fs::recursive_directory_iterator(folder_)) {
      if (entry.is_regular_file()) return entry.path();
    }
    throw std::logic_error("no file");
  }
  // Makes a file older than the others.
  static void age(const fs::path& path, int minutes) {
    fs::last_write_time(path, fs::last_write_time(path) - std::chrono::minutes(minutes));
  }

  const TemporaryFolder temporary_;
  const fs::path folder_ = temporary_ / "deep/levels";
  LevelCache cache_{folder_, kServer};
};

TEST_F(LevelCacheTest, KeepsALevelForTheNextProgram) {
  const auto level = levelOf("A");
  EXPECT_EQ(cache_.load(level->hash), nullptr);
  EXPECT_TRUE(cache_.newest(8).empty());
  cache_.keep(*level);
  LevelCache again(folder_, kServer);
  EXPECT_EQ(again.newest(8), std::vector{level->hash});
  const auto loaded = again.load(level->hash);
  ASSERT_TRUE(loaded);
  EXPECT_EQ(loaded->text, level->text);
  EXPECT_EQ(files(), 1u);
}

TEST_F(LevelCacheTest, AServerDoesNotLearnOfTheLevelsOfOthers) {
  const auto level = levelOf("A");
  cache_.keep(*level);
  LevelCache other(folder_, kOtherServer);
  EXPECT_TRUE(other.newest(8).empty());
  EXPECT_EQ(other.load(level->hash), nullptr);
}

TEST_F(LevelCacheTest, ADamagedFileIsNotUsedAndRemoved) {
  const auto level = levelOf("A");
  const std::string texts[] = {"", level->text.substr(1), level->text + "\n", "# other\n" + level->text,
                               std::string(kMaxLevelBytes + 1, 'x')};
  for (const std::string& text : texts) {
    cache_.keep(*level);
    writeText(file(), text);
    EXPECT_EQ(cache_.load(level->hash), nullptr);
    EXPECT_EQ(files(), 0u);
  }
}

TEST_F(LevelCacheTest, TheNewestIsTheOneThatWasUsedLast) {
  const auto a = levelOf("A");
  const auto b = levelOf("B");
  cache_.keep(*a);
  age(file(), 10);
  const fs::path first = file();
  cache_.keep(*b);
  EXPECT_EQ(cache_.newest(1), std::vector{b->hash});
  for (const auto& entry : fs::directory_iterator(first.parent_path())) age(entry.path(), 5);
  EXPECT_TRUE(cache_.load(a->hash));
  EXPECT_EQ(cache_.newest(8), (std::vector{a->hash, b->hash}));
}

TEST_F(LevelCacheTest, FilesWithOtherNamesAreNotLevels) {
  cache_.keep(*levelOf("A"));
  const fs::path folder = file().parent_path();
  for (const char* name :
       {"readme", "0123456789ABCDEF", "0123456789abcde", "00123456789abcdef", "0123456789abcdef.new"})
    writeText(folder / name, "x");
  EXPECT_EQ(cache_.newest(8).size(), 1u);
}

TEST_F(LevelCacheTest, TheLevelsThatWereUsedLongestAgoOfAllServersAreRemoved) {
  LevelCache other(folder_, kOtherServer);
  const auto oldest = levelOf("oldest");
  other.keep(*oldest);
  age(file(), 60);
  for (std::size_t i = 1; i < LevelCache::kMaxLevels; ++i) cache_.keep(*levelOf(std::to_string(i)));
  EXPECT_EQ(files(), LevelCache::kMaxLevels);
  EXPECT_EQ(other.newest(8).size(), 1u);
  cache_.keep(*levelOf("one more"));
  EXPECT_EQ(files(), LevelCache::kMaxLevels);
  EXPECT_TRUE(other.newest(8).empty());
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1) << "no empty folders";
}

TEST_F(LevelCacheTest, TheBytesOfAllLevelsAreLimited) {
  constexpr std::size_t kComment = std::size_t{4'000'000};
  static_assert(kComment < kMaxLevelBytes);
  constexpr std::size_t kFit = LevelCache::kMaxBytes / (kComment + 200);
  for (std::size_t i = 0; i < kFit + 3; ++i) cache_.keep(*levelOf(std::to_string(i), kComment));
  EXPECT_GE(files(), kFit - 1);
  EXPECT_LE(files(), kFit + 1);
}

TEST_F(LevelCacheTest, WithoutAFolderNothingIsStored) {
  const auto level = levelOf("A");
  writeText(temporary_ / "file", "");
  for (const fs::path& folder : {fs::path(), temporary_ / "file/levels"}) {
    LevelCache cache(folder, kServer);
    cache.keep(*level);
    EXPECT_EQ(cache.load(level->hash), nullptr);
    EXPECT_TRUE(cache.newest(8).empty());
  }
}

}  // namespace
}  // namespace platon::server_files_test
