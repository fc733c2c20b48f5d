#include "protocol/files/bounded_folder.h"

#include <algorithm>
#include <chrono>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace platon::bounded_folder_test {
namespace {

namespace fs = std::filesystem;

class BoundedFolderTest : public testing::Test {
 protected:
  // A file that was written so many hours ago.
  void write(const std::string& name, int hours, const std::string& text = "x") const {
    fs::create_directories((folder_ / name).parent_path());
    writeText(folder_ / name, text);
    fs::last_write_time(folder_ / name, fs::file_time_type::clock::now() - std::chrono::hours(hours));
  }
  std::vector<std::string> names(Subfolders subfolders) const {
    std::vector<std::string> found;
    for (const DatedFile& file : newestFiles(folder_.path(), subfolders, isText)) {
      found.push_back(fs::relative(file.path, folder_.path()).string());
    }
    return found;
  }
  static bool isText(const fs::path& path) { return path.extension() == ".txt"; }

  const TemporaryFolder folder_;
};

using Names = std::vector<std::string>;

TEST_F(BoundedFolderTest, TheNewestIsTheFirst) {
  write("a.txt", 2);
  write("b.txt", 1);
  write("c.txt", 3);
  write("other", 0);
  write("in/d.txt", 0);
  EXPECT_EQ(names(Subfolders::kWithout), (Names{"b.txt", "a.txt", "c.txt"}));
  EXPECT_EQ(names(Subfolders::kWith), (Names{"in/d.txt", "b.txt", "a.txt", "c.txt"}));
}

// Root may read everything, so it acts as another user.
TEST_F(BoundedFolderTest, ASubfolderThatCannotBeReadHidesNothingElse) {
  constexpr uid_t kNobody = 65534;
  write("a.txt", 1);
  for (const char* const sub : {"b", "c", "d"}) write(std::string(sub) + "/" + sub + ".txt", 2);
  const bool isRoot = geteuid() == 0;
  ASSERT_EQ(isRoot ? chown(folder_.path().c_str(), kNobody, kNobody) : 0, 0);
  for (const char* const locked : {"b", "c", "d"}) {
    Names expected{"a.txt"};
    for (const std::string sub : {"b", "c", "d"}) {
      if (sub != locked) expected.push_back(sub + "/" + sub + ".txt");
    }
    fs::permissions(folder_ / locked, fs::perms::none);
    ASSERT_EQ(isRoot ? seteuid(kNobody) : 0, 0);
    Names found = names(Subfolders::kWith);
    ASSERT_EQ(isRoot ? seteuid(0) : 0, 0);
    fs::permissions(folder_ / locked, fs::perms::all);
    std::sort(found.begin(), found.end());
    EXPECT_EQ(found, expected) << locked;
  }
}

TEST_F(BoundedFolderTest, TheOldestGoWhereThereAreTooManyFilesOrBytes) {
  write("a.txt", 4, "12345");
  write("b.txt", 3, "12345");
  write("c.txt", 2, "12345");
  write("d.txt", 1, "12345");
  const auto limit = [&](std::size_t files, std::uint64_t bytes) {
    removeOldest(newestFiles(folder_.path(), Subfolders::kWithout, isText), files, bytes);
  };
  limit(4, 20);
  EXPECT_EQ(names(Subfolders::kWithout).size(), 4U);
  limit(3, 20);
  EXPECT_EQ(names(Subfolders::kWithout), (Names{"d.txt", "c.txt", "b.txt"}));
  limit(3, 14);
  EXPECT_EQ(names(Subfolders::kWithout), (Names{"d.txt", "c.txt"}));
}

TEST_F(BoundedFolderTest, AFolderThatIsMissingIsEmpty) {
  EXPECT_TRUE(newestFiles(folder_ / "missing", Subfolders::kWith, isText).empty());
  EXPECT_TRUE(newestFiles(folder_ / "missing", Subfolders::kWithout, isText).empty());
}

}  // namespace
}  // namespace platon::bounded_folder_test
