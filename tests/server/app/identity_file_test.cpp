#include "server/app/identity_file.h"

#include <gtest/gtest.h>

#include "protocol/program_error.h"
#include "tests/support/environment_variable.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace platon::identity_file_test {
namespace {

class IdentityFileTest : public testing::Test {
 protected:
  CryptoKey load(const std::string& keyFile = "") { return loadIdentity(keyFile, log_).publicKey(); }

  const TemporaryFolder folder_;
  std::string written_;
  Log log_{LogFormat::kText, [this](std::string_view line) { written_ += line; }};
};

TEST_F(IdentityFileTest, TheDefaultFileIsInTheStateFolder) {
  const EnvironmentVariable state("STATE_DIRECTORY", folder_ / "state");
  const CryptoKey made = load();
  EXPECT_TRUE(std::filesystem::exists(folder_ / "state/server.key"));
  EXPECT_EQ(load(), made);
  EXPECT_EQ(written_, "");
}

TEST_F(IdentityFileTest, WithoutAStateFolderItIsInTheDataFolder) {
  const EnvironmentVariable state("STATE_DIRECTORY", "");
  const EnvironmentVariable data("XDG_DATA_HOME", folder_.path());
  const CryptoKey made = load();
  EXPECT_EQ(load(folder_ / "platon/server.key"), made);
}

TEST_F(IdentityFileTest, WithoutAFolderTheServerStartsAndWarns) {
  writeText(folder_ / "file", "");
  const EnvironmentVariable state("STATE_DIRECTORY", folder_ / "file");
  EXPECT_NE(load(), load());
  EXPECT_TRUE(written_.starts_with("the key of the server is not kept")) << written_;
}

TEST_F(IdentityFileTest, AFileThatOthersMayOpenIsUsedAndWarnedOf) {
  const EnvironmentVariable state("STATE_DIRECTORY", folder_ / "state");
  const CryptoKey made = load();
  const std::string file = folder_ / "state/server.key";
  std::filesystem::permissions(file, std::filesystem::perms::others_read, std::filesystem::perm_options::add);
  for (const std::string& named : {std::string(), file}) {
    written_.clear();
    EXPECT_EQ(load(named), made);
    EXPECT_TRUE(written_.starts_with("the key of the server is not private file=\"" + file)) << written_;
    EXPECT_NE(written_.find("chmod 600 " + file), std::string::npos) << written_;
  }
}

TEST_F(IdentityFileTest, ANamedFileMustBeUsable) { EXPECT_THROW(load(folder_ / "missing/key"), ProgramError); }

}  // namespace
}  // namespace platon::identity_file_test
