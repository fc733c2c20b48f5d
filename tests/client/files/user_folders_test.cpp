#include "client/files/user_folders.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <optional>

#include "tests/support/environment_variable.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace platon::user_folders_test {
namespace {

class UserFoldersTest : public testing::Test {
 protected:
  const EnvironmentVariable home_{"HOME", std::nullopt};
  const EnvironmentVariable config_{"XDG_CONFIG_HOME", std::nullopt};
  const EnvironmentVariable data_{"XDG_DATA_HOME", std::nullopt};
  const EnvironmentVariable state_{"XDG_STATE_HOME", std::nullopt};
  const EnvironmentVariable cache_{"XDG_CACHE_HOME", std::nullopt};
};

TEST_F(UserFoldersTest, AreEmptyWithoutAHomeFolder) {
  EXPECT_EQ(configFolder(), "");
  EXPECT_EQ(dataFolder(), "");
  EXPECT_EQ(stateFolder(), "");
  EXPECT_EQ(cacheFolder(), "");
  EXPECT_EQ(bestTimesFile(), "");
  EXPECT_EQ(runsFolder(), "");
  EXPECT_EQ(ghostsFolder(), "");
  EXPECT_EQ(ownLevelsFolder(), "");
  home_.set("");
  EXPECT_EQ(configFolder(), "");
  EXPECT_EQ(dataFolder(), "");
  EXPECT_EQ(stateFolder(), "");
  EXPECT_EQ(cacheFolder(), "");
}

TEST_F(UserFoldersTest, AreInTheHomeFolderByDefault) {
  home_.set("/somewhere");
  config_.set("");
  EXPECT_EQ(configFolder(), "/somewhere/.config/platon");
  EXPECT_EQ(dataFolder(), "/somewhere/.local/share/platon");
  EXPECT_EQ(stateFolder(), "/somewhere/.local/state/platon");
  EXPECT_EQ(cacheFolder(), "/somewhere/.cache/platon");
}

TEST_F(UserFoldersTest, FollowTheXdgVariables) {
  home_.set("/somewhere");
  config_.set("/config");
  data_.set("/data");
  state_.set("/state");
  cache_.set("/cache");
  EXPECT_EQ(configFolder(), "/config/platon");
  EXPECT_EQ(dataFolder(), "/data/platon");
  EXPECT_EQ(stateFolder(), "/state/platon");
  EXPECT_EQ(cacheFolder(), "/cache/platon");
  EXPECT_EQ(runsFolder(), "/data/platon/runs");
  EXPECT_EQ(ghostsFolder(), "/data/platon/ghosts");
}

TEST_F(UserFoldersTest, PicturesGoWhereTheUserKeepsThem) {
  const TemporaryFolder folder;
  const EnvironmentVariable pictures("XDG_PICTURES_DIR", std::nullopt);
  EXPECT_EQ(picturesFolder(), "");
  home_.set(folder.path().string());
  EXPECT_EQ(picturesFolder(), folder / "Pictures");
  std::filesystem::create_directories(folder / ".config");
  writeText(folder / ".config/user-dirs.dirs", "# folders\nXDG_PICTURES_DIR=\"$HOME/Bilder\"\n");
  EXPECT_EQ(picturesFolder(), folder / "Bilder");
  pictures.set("/pictures");
  EXPECT_EQ(picturesFolder(), "/pictures");
}

TEST_F(UserFoldersTest, APipeInPlaceOfTheNamesOfFoldersIsNotWaitedFor) {
  const TemporaryFolder folder;
  const EnvironmentVariable pictures("XDG_PICTURES_DIR", std::nullopt);
  home_.set(folder.path());
  std::filesystem::create_directories(folder / ".config");
  ASSERT_EQ(mkfifo((folder / ".config/user-dirs.dirs").c_str(), 0600), 0);
  EXPECT_EQ(picturesFolder(), folder / "Pictures");
}

TEST(ServerFileName, IsHostAndPort) { EXPECT_EQ(serverFileName({"play.example.org", 7777}), "play.example.org_7777"); }

TEST(ServerFileName, CannotFormAPath) {
  EXPECT_EQ(serverFileName({"../a b", 1}), "..%2fa%20b_1");
  EXPECT_EQ(serverFileName({"2001:db8::1", 65535}), "2001%3adb8%3a%3a1_65535");
  EXPECT_EQ(serverFileName({"\xc5\x81", 1}), "%c5%81_1");
}

}  // namespace
}  // namespace platon::user_folders_test
