#include "client/files/settings_file.h"

#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <gtest/gtest.h>

#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/wait_until.h"

namespace platon::settings_file_test {
namespace {

namespace fs = std::filesystem;

class SettingsFileTest : public testing::Test {
 protected:
  void write(const std::string& text) const {
    fs::create_directories(folder_);
    writeText(path_, text);
  }
  std::string read() const { return readText(path_); }
  // Starts and ends a game that changes nothing.
  Settings playOnce() const {
    SettingsFile file(folder_);
    const Settings settings = file.load();
    file.save(settings);
    return settings;
  }

  const TemporaryFolder temporary_;
  const fs::path folder_ = temporary_ / "folder";
  const fs::path path_ = folder_ / "settings";
};

TEST_F(SettingsFileTest, WithoutAFileTheSettingsAreTheDefaults) {
  EXPECT_EQ(SettingsFile(folder_).load().text(), Settings().text());
  EXPECT_FALSE(fs::exists(path_));
}

TEST_F(SettingsFileTest, SavedSettingsAreLoaded) {
  Settings settings;
  settings.zoom = 2;
  settings.fullscreen = true;
  SettingsFile(folder_).save(settings);
  EXPECT_EQ(SettingsFile(folder_).load().text(), settings.text());
}

TEST_F(SettingsFileTest, AChangeIsSavedWhenItHasStayedForASecond) {
  using std::chrono::milliseconds;
  SettingsFile file(folder_);
  Settings settings = file.load();
  Time now(0);
  const auto updateFor = [&](Time time) {
    for (const Time end = now + time; now < end; now += milliseconds(50)) file.update(settings, now);
  };
  updateFor(milliseconds(3000));
  EXPECT_FALSE(fs::exists(path_)) << "nothing has changed";
  for (int i = 0; i < 10; ++i) {
    settings.volume = i;
    updateFor(milliseconds(500));
  }
  EXPECT_FALSE(fs::exists(path_)) << "still changing";
  updateFor(SettingsFile::kCalmTime + milliseconds(500));
  ASSERT_TRUE(waitUntil([&] { return fs::exists(path_); }));
  EXPECT_EQ(read(), settings.text());
}

TEST_F(SettingsFileTest, OneBadLineDoesNotLoseTheOtherSettings) {
  const std::string broken = "turn-speed 12\nzoom huge\ncontrols screen\nfullscreen on\n";
  write(broken);
  testing::internal::CaptureStderr();
  const Settings settings = playOnce();
  EXPECT_EQ(testing::internal::GetCapturedStderr(),
            "platon-client: " + path_.string() + ": line 2: zoom must be a number from 0.5 to 2\n");
  EXPECT_EQ(settings.comfort.turnRate, 12);
  EXPECT_EQ(settings.zoom, Settings().zoom);
  EXPECT_EQ(settings.controls, ControlFrame::kScreen);
  EXPECT_TRUE(settings.fullscreen);
  EXPECT_EQ(read(), settings.text());
  EXPECT_EQ(readText(path_.string() + ".broken"), broken);
}

TEST_F(SettingsFileTest, AFileWithInvalidLinesIsKeptOnceBeforeItIsReplaced) {
  const std::string broken = "zoom 2\nkey jump spcae\nfragrance 7\nvolume loud\n";
  const fs::path kept = path_.string() + ".broken";
  write(broken);
  testing::internal::CaptureStderr();
  SettingsFile file(folder_);
  Settings settings = file.load();
  EXPECT_EQ(file.fault(),
            "2 lines of " + path_.string() + " are invalid; the next save keeps the old file as " + kept.string());
  EXPECT_EQ(read(), broken);
  EXPECT_FALSE(fs::exists(kept)) << "the file has not been replaced";
  file.save(settings);
  EXPECT_EQ(readText(kept), broken);
  fs::remove(kept);
  settings.zoom = 1.5;
  file.save(settings);
  EXPECT_EQ(read(), settings.text() + "fragrance 7\n");
  EXPECT_FALSE(fs::exists(kept)) << "kept again, although the file was valid then";
  testing::internal::GetCapturedStderr();
}

TEST_F(SettingsFileTest, AValidFileHasNoFaultAndAnInvalidLineIsCounted) {
  testing::internal::CaptureStderr();
  SettingsFile file(folder_);
  file.load();
  EXPECT_EQ(file.fault(), "");
  write("fragrance 7\nzoom 2\n");
  file.load();
  EXPECT_EQ(file.fault(), "");
  write("zoom\n");
  file.load();
  EXPECT_EQ(file.fault(), "1 line of " + path_.string() + " is invalid; the next save keeps the old file as " +
                              path_.string() + ".broken");
  testing::internal::GetCapturedStderr();
}

TEST_F(SettingsFileTest, AFileWithInvalidLinesStaysIfItCannotBeKept) {
  const std::string broken = "zoom huge\n";
  write(broken);
  const std::string kept = path_.string() + ".broken";
  fs::create_directories(fs::path(kept) / "not a file");
  testing::internal::CaptureStderr();
  playOnce();
  EXPECT_NE(testing::internal::GetCapturedStderr().find("platon-client: cannot write " + path_.string() +
                                                        ": the old file cannot be kept as " + kept +
                                                        ": Is a directory; the settings are not saved\n"),
            std::string::npos);
  EXPECT_EQ(read(), broken);
}

TEST_F(SettingsFileTest, AFileThatCouldNotBeKeptIsReplacedAsSoonAsItCan) {
  const std::string broken = "zoom huge\n";
  write(broken);
  const fs::path kept = path_.string() + ".broken";
  fs::create_directories(kept / "not a file");
  testing::internal::CaptureStderr();
  SettingsFile file(folder_);
  Settings settings = file.load();
  settings.zoom = 2;
  file.save(settings);
  EXPECT_EQ(read(), broken);
  fs::remove_all(kept);
  Time now(0);
  EXPECT_TRUE(waitUntil([&] {
    file.update(settings, now += std::chrono::seconds(1));
    return read() == settings.text();
  })) << "without another change";
  EXPECT_EQ(readText(kept), broken);
  testing::internal::GetCapturedStderr();
}

TEST_F(SettingsFileTest, TheCopyOfALaterFileWithInvalidLinesReplacesTheFirst) {
  testing::internal::CaptureStderr();
  for (const char* const broken : {"zoom huge\n", "zoom tiny\n"}) {
    write(broken);
    playOnce();
    EXPECT_EQ(readText(path_.string() + ".broken"), broken);
  }
  testing::internal::GetCapturedStderr();
}

TEST_F(SettingsFileTest, AFileThatCannotBeReadAsAWholeIsNotWritten) {
  const std::string large = "zoom 2\n" + std::string(1 << 20, '#');
  write(large);
  testing::internal::CaptureStderr();
  SettingsFile file(folder_);
  const Settings settings = file.load();
  EXPECT_EQ(file.fault(), path_.string() +
                              " cannot be read: it has more than 1048576 bytes; remove lines that you do not need; the "
                              "settings are not saved");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "platon-client: " + file.fault() + "\n");
  EXPECT_EQ(settings.text(), Settings().text());
  file.save(settings);
  EXPECT_EQ(read(), large);
  fs::remove(path_);
  fs::create_directories(path_);
  testing::internal::CaptureStderr();
  SettingsFile folder(folder_);
  folder.load();
  EXPECT_EQ(
      folder.fault(),
      path_.string() + " cannot be read: Is a directory; make it readable or move it away; the settings are not saved");
  testing::internal::GetCapturedStderr();
}

TEST_F(SettingsFileTest, LinesOfUnknownSettingsAreKept) {
  write("colour-blind  on  # of a later version\nzoom 2\nfragrance 7\n");
  testing::internal::CaptureStderr();
  Settings settings = playOnce();
  settings = playOnce();
  testing::internal::GetCapturedStderr();
  EXPECT_EQ(settings.zoom, 2);
  EXPECT_EQ(read(), settings.text() + "colour-blind  on  # of a later version\nfragrance 7\n");
}

// A save of the older one lost them.
TEST_F(SettingsFileTest, SettingsThatANewerProgramSavesMeanwhileAreKept) {
  SettingsFile file(folder_);
  const Settings settings = file.load();
  write(settings.text() + "fragrance 7\n");
  file.save(settings);
  EXPECT_EQ(read(), settings.text() + "fragrance 7\n");
}

TEST_F(SettingsFileTest, SavingReplacesTheFileAndLeavesNoOther) {
  write("zoom 2\n");
  std::ifstream before(path_);
  playOnce();
  const std::string old{std::istreambuf_iterator<char>(before), std::istreambuf_iterator<char>()};
  EXPECT_EQ(old, "zoom 2\n") << "the file was overwritten in place, so that it could be left half written";
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 2) << "it and its lock";
}

TEST_F(SettingsFileTest, AnUnwritableFileIsReportedAndKept) {
  fs::create_directories(path_ / "not a file");
  testing::internal::CaptureStderr();
  SettingsFile(folder_).save(Settings());
  EXPECT_EQ(testing::internal::GetCapturedStderr(),
            "platon-client: cannot write " + path_.string() +
                ": Is a directory; make it readable or move it away; the settings are not saved\n");
  EXPECT_TRUE(fs::exists(path_ / "not a file"));
}

TEST_F(SettingsFileTest, WithoutAFolderNothingIsSaved) {
  SettingsFile file{fs::path()};
  testing::internal::CaptureStderr();
  file.save(file.load());
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace platon::settings_file_test
