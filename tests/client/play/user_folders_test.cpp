#include "client/play/user_folders.h"

#include <array>
#include <cstddef>
#include <cstdlib>
#include <optional>
#include <string>

#include <gtest/gtest.h>

namespace platon {
namespace {

constexpr std::array<const char*, 3> kVariables{"HOME", "XDG_CONFIG_HOME", "XDG_DATA_HOME"};

// Unsets the variables and restores them at the end.
class UserFoldersTest : public testing::Test {
 protected:
  UserFoldersTest() {
    for (std::size_t i = 0; i < kVariables.size(); ++i) {
      const char* const value = std::getenv(kVariables[i]);
      if (value != nullptr) saved_[i] = value;
      unsetenv(kVariables[i]);
    }
  }
  ~UserFoldersTest() override {
    for (std::size_t i = 0; i < kVariables.size(); ++i) {
      unsetenv(kVariables[i]);
      if (saved_[i]) setenv(kVariables[i], saved_[i]->c_str(), 1);
    }
  }

 private:
  std::array<std::optional<std::string>, kVariables.size()> saved_;
};

TEST_F(UserFoldersTest, AreEmptyWithoutAHomeFolder) {
  EXPECT_EQ(configFolder(), "");
  EXPECT_EQ(dataFolder(), "");
  setenv("HOME", "", 1);
  EXPECT_EQ(configFolder(), "");
  EXPECT_EQ(dataFolder(), "");
}

TEST_F(UserFoldersTest, AreInTheHomeFolderByDefault) {
  setenv("HOME", "/somewhere", 1);
  setenv("XDG_CONFIG_HOME", "", 1);
  EXPECT_EQ(configFolder(), "/somewhere/.config/platon");
  EXPECT_EQ(dataFolder(), "/somewhere/.local/share/platon");
}

TEST_F(UserFoldersTest, FollowTheXdgVariables) {
  setenv("HOME", "/somewhere", 1);
  setenv("XDG_CONFIG_HOME", "/config", 1);
  setenv("XDG_DATA_HOME", "/data", 1);
  EXPECT_EQ(configFolder(), "/config/platon");
  EXPECT_EQ(dataFolder(), "/data/platon");
}

}  // namespace
}  // namespace platon
