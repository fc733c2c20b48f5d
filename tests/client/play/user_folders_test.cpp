#include "client/play/user_folders.h"

#include <optional>

#include <gtest/gtest.h>

#include "tests/support/environment_variable.h"

namespace platon {
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
  EXPECT_EQ(runsFolder(), "");
  EXPECT_EQ(ghostsFolder(), "");
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

}  // namespace
}  // namespace platon
