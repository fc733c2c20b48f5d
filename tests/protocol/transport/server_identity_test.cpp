#include "protocol/transport/server_identity.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "protocol/files/descriptor.h"
#include "protocol/program_error.h"
#include "tests/net/support/hex.h"
#include "tests/support/files.h"
#include "tests/support/resource_limit.h"
#include "tests/support/temporary_folder.h"

namespace platon::server_identity_test {
namespace {

// RFC 8032, section 7.1, test 1.
const CryptoKey kSecret = keyFromHex("9d61b19deffd5a60ba844af492ec2cc44449c5697b326919703bac031cae7f60");

TEST(ServerIdentity, HasThePublicKeyOfTheRfc) {
  EXPECT_EQ(toHex(ServerIdentity(kSecret).publicKey()),
            "d75a980182b10ab7d54bfed3c964073a0ee172f3daa62325af021a68f707511a");
}

TEST(ServerIdentity, ClientsDeriveTheSameExchangeKey) {
  for (int i = 0; i < 10; ++i) {
    const ServerIdentity identity = ServerIdentity::random();
    EXPECT_EQ(exchangeKeyOf(identity.publicKey()), identity.exchangeKeys().publicKey);
  }
  EXPECT_EQ(exchangeKeyOf(CryptoKey{}), std::nullopt);  // of small order
}

TEST(ServerIdentity, ItsTextIsReadBack) {
  const ServerIdentity identity(kSecret);
  const std::string text = identity.text();
  EXPECT_EQ(text, "platon-server-key nWGxne_9WmC6hEr0kuwsxERJxWl7MmkZcDusAxyuf2A");
  EXPECT_EQ(ServerIdentity::parse(text)->publicKey(), identity.publicKey());
  EXPECT_FALSE(ServerIdentity::parse(text.substr(0, text.size() - 1)));
  EXPECT_FALSE(ServerIdentity::parse(text + "A"));
  EXPECT_FALSE(ServerIdentity::parse(text.substr(1)));
  EXPECT_FALSE(ServerIdentity::parse(""));
}

TEST(ServerIdentity, APublicKeyHas43Characters) {
  const CryptoKey key = ServerIdentity::random().publicKey();
  EXPECT_EQ(textOf(key).size(), 43u);
  EXPECT_EQ(keyOf(textOf(key)), key);
  EXPECT_EQ(keyOf("not a key"), std::nullopt);
}

TEST(PresharedKey, DependsOnPasswordAndServer) {
  const CryptoKey key = presharedKeyOf("secret", CryptoKey{1});
  EXPECT_EQ(key, presharedKeyOf("secret", CryptoKey{1}));
  EXPECT_NE(key, presharedKeyOf("Secret", CryptoKey{1}));
  EXPECT_NE(key, presharedKeyOf("secret", CryptoKey{2}));
}

TEST(Password, GivesThePresharedKeyOfEachServer) {
  const Password password("sesame");
  EXPECT_FALSE(password.empty());
  for (const CryptoKey& server : {CryptoKey{}, CryptoKey{1}, CryptoKey{2}}) {
    EXPECT_EQ(password.keyFor(server), presharedKeyOf("sesame", server));
  }
}

TEST(Password, CopiesDeriveTheKeyOfAServerOnce) {
  const std::vector<Password> copies(3, Password("sesame"));
  EXPECT_EQ(copies[0].derivations(), 0u);
  const CryptoKey key = copies[0].keyFor(CryptoKey{1});
  EXPECT_EQ(copies[1].keyFor(CryptoKey{1}), key);
  EXPECT_EQ(copies[2].keyFor(CryptoKey{1}), key);
  for (const Password& copy : copies) EXPECT_EQ(copy.derivations(), 1u);
  EXPECT_NE(copies[1].keyFor(CryptoKey{2}), key);
  EXPECT_EQ(copies[0].derivations(), 2u);
}

TEST(Password, AnEmptyTextIsNone) {
  EXPECT_TRUE(Password().empty());
  EXPECT_TRUE(Password("").empty());
}

// Called before a link is made: returns an error number, or 0 to make it.
std::function<int()> beforeLink;

}  // namespace
}  // namespace platon::server_identity_test

// Used by this program instead of that of the C library.
extern "C" int link(const char* from, const char* to) noexcept {
  using platon::server_identity_test::beforeLink;
  const int fault = beforeLink ? beforeLink() : 0;
  if (fault == 0) return static_cast<int>(syscall(SYS_linkat, AT_FDCWD, from, AT_FDCWD, to, 0));
  errno = fault;
  return -1;
}

namespace platon::server_identity_test {
namespace {

// Sets beforeLink in a scope.
class Link {
 public:
  explicit Link(std::function<int()> before) { beforeLink = std::move(before); }
  Link(const Link&) = delete;
  Link& operator=(const Link&) = delete;
  ~Link() { beforeLink = nullptr; }
};

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

TEST(SecretFile, OnlyAKeyThatOthersMayOpenIsWarnedOf) {
  const TemporaryFolder folder;
  const std::string path = folder / "key";
  EXPECT_EQ(keyFileWarning(path), "");
  readKeyFile(path);
  for (const mode_t mode : {0600U, 0400U}) {
    ASSERT_EQ(chmod(path.c_str(), mode), 0);
    EXPECT_EQ(keyFileWarning(path), "");
  }
  for (const mode_t mode : {0644U, 0640U, 0604U, 0660U}) {
    ASSERT_EQ(chmod(path.c_str(), mode), 0);
    EXPECT_EQ(keyFileWarning(path),
              "others may open the file, and anyone who has the key can pose as the server; run chmod 600 " + path);
  }
}

TEST(SecretFile, AFileThatIsNoKeyIsRefusedAndKept) {
  const TemporaryFolder folder;
  const std::string path = folder / "key";
  writeText(path, "something else\n");
  EXPECT_EQ(errorOf([&] { readKeyFile(path); }),
            path + ": error: not a key of platon-server; for a new key, name a file that does not exist");
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

// As on vfat and exFAT.
TEST(SecretFile, AFileSystemWithoutLinksKeepsAKeyToo) {
  const TemporaryFolder folder;
  const std::string path = folder / "key";
  for (const int fault : {EPERM, EOPNOTSUPP, ENOSYS}) {
    const Link link([fault] { return fault; });
    const ServerIdentity made = readKeyFile(path);
    EXPECT_EQ(readKeyFile(path).publicKey(), made.publicKey());
    using std::filesystem::perms;
    EXPECT_EQ(std::filesystem::status(path).permissions(), perms::owner_read | perms::owner_write);
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
    std::filesystem::remove(path);
  }
}

TEST(SecretFile, AFullDiskWithoutLinksLeavesNothingOfAKey) {
  const TemporaryFolder folder;
  const std::string path = folder / "key";
  std::optional<FullDisk> disk;
  const Link link([&disk] {
    disk.emplace(rlim_t{43});
    return EPERM;
  });
  EXPECT_EQ(errorOf([&] { readKeyFile(path); }),
            path + ": error: cannot be written: File too large; make room on the disk");
  disk.reset();
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(SecretFile, AKeyThatAnotherServerHasJustMadeIsTaken) {
  const TemporaryFolder folder;
  const std::string path = folder / "key";
  const ServerIdentity other = ServerIdentity::random();
  for (const int fault : {0, EPERM}) {
    const Link link([&] {
      writeText(path, other.text() + "\n");
      return fault;
    });
    EXPECT_EQ(readKeyFile(path).publicKey(), other.publicKey());
    EXPECT_EQ(readText(path), other.text() + "\n");
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
    std::filesystem::remove(path);
  }
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

// As `--password-file <(pass platon)` in a shell.
TEST(SecretFile, APasswordMayComeFromAPipe) {
  std::array<int, 2> ends{};
  ASSERT_EQ(pipe2(ends.data(), O_CLOEXEC), 0);
  const Descriptor output(ends[0]);
  {
    const Descriptor input(ends[1]);
    ASSERT_EQ(write(input.number(), "open sesame\n", 12), 12);
  }
  EXPECT_EQ(readPasswordFile("/dev/fd/" + std::to_string(output.number())), "open sesame");
}

TEST(SecretFile, WhatIsNoRegularFileOrTooLargeIsRefused) {
  const TemporaryFolder folder;
  const std::string path = folder / "secret";
  const auto expectRefused = [&path](const std::string& why) {
    EXPECT_EQ(errorOf([&] { readPasswordFile(path); }), path + ": error: " + why);
    EXPECT_EQ(errorOf([&] { readKeyFile(path); }), path + ": error: " + why);
    std::filesystem::remove(path);
  };
  ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
  EXPECT_EQ(errorOf([&] { readPasswordFile(path); }),
            path + ": error: the first line is empty; write the password there")
      << "a pipe that nobody writes";
  EXPECT_EQ(errorOf([&] { readKeyFile(path); }),
            path + ": error: it is a pipe, not a regular file; name a readable file");
  std::filesystem::remove(path);
  std::filesystem::create_symlink("/dev/zero", path);
  expectRefused("it is a device, not a regular file; name a readable file");
  writeText(path, "secret\n" + std::string(4090, 'x'));
  expectRefused("it has more than 4096 bytes; name a file with one line");
  writeText(path, "secret\n" + std::string(4089, 'x'));
  EXPECT_EQ(readPasswordFile(path), "secret");
}

}  // namespace
}  // namespace platon::server_identity_test
