#include "client/files/edit_file.h"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <iterator>
#include <optional>
#include <string>

#include "protocol/program_error.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace platon::edit_file_test {
namespace {

namespace fs = std::filesystem;

class EditFileTest : public testing::Test {
 protected:
  // Another program writes the file, some time later.
  void writeLater(const std::string& text) {
    const auto before = fs::last_write_time(path_);
    writeText(path_, text);
    fs::last_write_time(path_, before + std::chrono::seconds(2));
  }

  const TemporaryFolder folder_;
  const fs::path path_ = folder_ / "a.level";
  EditFile file_{path_};
};

TEST_F(EditFileTest, SavingCreatesTheFileAndLeavesNothingElse) {
  EXPECT_FALSE(file_.exists());
  EXPECT_EQ(file_.save("text\r\n"), std::nullopt);
  EXPECT_EQ(readText(path_), "text\r\n");
  EXPECT_EQ(std::distance(fs::directory_iterator(path_.parent_path()), fs::directory_iterator()), 1);
}

TEST_F(EditFileTest, AChangeOfAnotherProgramIsToldOnce) {
  writeText(path_, "one");
  EXPECT_EQ(file_.load(), "one");
  EXPECT_EQ(file_.takeChange(), std::nullopt);
  writeLater("two");
  EXPECT_EQ(file_.takeChange(), "two");
  EXPECT_EQ(file_.takeChange(), std::nullopt);
}

TEST_F(EditFileTest, AChangeIsReadOnceTheFileStaysTheSame) {
  FileWatch::Time now{};
  const auto pollLater = [&] { return file_.pollChange(now += FileWatch::kInterval); };
  writeText(path_, "one");
  EXPECT_EQ(file_.load(), "one");
  pollLater();
  pollLater();
  writeLater("two");
  EXPECT_EQ(pollLater(), std::nullopt) << "still being written, perhaps";
  EXPECT_EQ(file_.pollChange(now), std::nullopt) << "too early";
  EXPECT_EQ(pollLater(), "two");
  EXPECT_EQ(file_.save("three"), std::nullopt);
  pollLater();
  EXPECT_EQ(pollLater(), std::nullopt) << "the own text";
}

TEST_F(EditFileTest, TheOwnSaveAndAnEqualTextAreNoChange) {
  EXPECT_EQ(file_.save("one"), std::nullopt);
  EXPECT_EQ(file_.takeChange(), std::nullopt);
  writeLater("one");
  EXPECT_EQ(file_.takeChange(), std::nullopt);
}

TEST_F(EditFileTest, ASymbolicLinkStays) {
  writeText(path_, "one");
  const fs::path link = folder_ / "link.level";
  fs::create_symlink(path_, link);
  EditFile file(link);
  EXPECT_EQ(file.save("two"), std::nullopt);
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_EQ(readText(path_), "two");
}

TEST_F(EditFileTest, WhyItCannotBeWrittenIsSaid) {
  EditFile file(folder_ / "missing" / "a.level");
  const auto fault = file.save("text");
  ASSERT_TRUE(fault);
  EXPECT_NE(fault->find("cannot write"), std::string::npos);
}

TEST_F(EditFileTest, AFolderIsNoLevel) {
  EditFile file(path_.parent_path());
  EXPECT_THROW(file.load(), ProgramError);
}

}  // namespace
}  // namespace platon::edit_file_test
