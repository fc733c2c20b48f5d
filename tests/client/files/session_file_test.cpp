#include "client/files/session_file.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <optional>
#include <string>

#include "tests/support/temporary_folder.h"

namespace platon::session_file_test {
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

}  // namespace
}  // namespace platon::session_file_test
