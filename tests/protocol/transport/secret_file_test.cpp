#include "protocol/transport/secret_file.h"

#include <gtest/gtest.h>

#include "protocol/program_error.h"
#include "tests/support/files.h"
#include "tests/support/resource_limit.h"
#include "tests/support/temporary_folder.h"

namespace platon {
namespace {

template <class Action>
std::string errorOf(Action action) {
  try {
    action();
  } catch (const ProgramError& error) {
    EXPECT_EQ(error.exitCode(), ProgramError::kUsage);
    return error.what();
  }
  return "none";
}

TEST(SecretFile, ThePasswordIsTheFirstLine) {
  const TemporaryFolder folder;
  const std::string path = folder / "password";
  for (const char* text : {"open sesame", "open sesame\n", "open sesame\r\nsecond line\n"}) {
    writeText(path, text);
    EXPECT_EQ(readPasswordFile(path), "open sesame");
  }
  writeText(path, "\nsecond\n");
  EXPECT_EQ(errorOf([&] { readPasswordFile(path); }),
            path + ": error: the first line is empty; write the password there");
  EXPECT_EQ(errorOf([&] { readPasswordFile(path + "s"); }),
            path + "s: error: No such file or directory; name a readable file");
}

TEST(SecretFile, AMissingKeyFileIsMadeForTheOwnerOnly) {
  const TemporaryFolder folder;
  const std::string path = folder / "key";
  const ServerIdentity made = readKeyFile(path);
  EXPECT_EQ(readKeyFile(path).publicKey(), made.publicKey());
  using std::filesystem::perms;
  EXPECT_EQ(std::filesystem::status(path).permissions(), perms::owner_read | perms::owner_write);
}

TEST(SecretFile, AFileThatIsNoKeyIsRefusedAndKept) {
  const TemporaryFolder folder;
  const std::string path = folder / "key";
  writeText(path, "something else\n");
  EXPECT_EQ(errorOf([&] { readKeyFile(path); }),
            path + ": error: not a key of platon-server; name a file that does not exist to have one made");
  EXPECT_EQ(readText(path), "something else\n");
  const std::string nowhere = folder / "missing/key";
  EXPECT_EQ(errorOf([&] { readKeyFile(nowhere); }),
            nowhere + ": error: cannot be created: No such file or directory; name a file in a writable folder");
}

TEST(SecretFile, AFullDiskLeavesNothingOfAKey) {
  const TemporaryFolder folder;
  const std::string path = folder / "key";
  for (const rlim_t bytes : {rlim_t{0}, rlim_t{1}, rlim_t{43}}) {
    const FullDisk disk(bytes);
    EXPECT_EQ(errorOf([&] { readKeyFile(path); }),
              path + ": error: cannot be written: File too large; make room on the disk");
    EXPECT_TRUE(std::filesystem::is_empty(folder.path())) << bytes;
  }
  const ServerIdentity made = readKeyFile(path);
  EXPECT_EQ(readKeyFile(path).publicKey(), made.publicKey()) << "the next start makes a key and keeps it";
}

TEST(SecretFile, AMadeKeyReplacesNothing) {
  const TemporaryFolder folder;
  const std::string path = folder / "key";
  std::filesystem::create_symlink("missing", path);
  EXPECT_EQ(errorOf([&] { readKeyFile(path); }),
            path + ": error: cannot be created: File exists; name a file in a writable folder");
  EXPECT_EQ(std::filesystem::read_symlink(path), "missing");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

TEST(SecretFile, TheCheckOfAKeyRefusesWhatReadingItWouldAndCreatesNothing) {
  const TemporaryFolder folder;
  const std::string path = folder / "key";
  EXPECT_FALSE(checkKeyFile(path));
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
  readKeyFile(path);
  EXPECT_TRUE(checkKeyFile(path));
  writeText(path, "something else\n");
  for (const std::string& refused : {path, (folder / "missing/key").string(), path + "/key", folder.path().string()}) {
    const std::string refusal = errorOf([&] { checkKeyFile(refused); });
    EXPECT_TRUE(refusal.starts_with(refused + ": error: ")) << refusal;
    EXPECT_EQ(refusal, errorOf([&] { readKeyFile(refused); }));
  }
}

}  // namespace
}  // namespace platon
