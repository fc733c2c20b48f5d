#include "protocol/files/private_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>
#include <thread>
#include <utility>

namespace platon {
namespace {

constexpr mode_t kOwnerOnly = S_IRUSR | S_IWUSR;
constexpr mode_t kOthers = S_IRWXG | S_IRWXO;
constexpr std::chrono::milliseconds kLockInterval{20};

// A file with a second name may be anybody's: a stranger can give a name in his folder to it.
bool keepFromOthers(const Descriptor& file) {
  struct stat status {};
  if (fstat(file.number(), &status) != 0) return false;
  const bool mine = status.st_uid == geteuid() && status.st_nlink == 1;
  return !mine || (status.st_mode & kOthers) == 0 || fchmod(file.number(), status.st_mode & kOwnerOnly) == 0;
}

}  // namespace

OpenedFile openPrivateFile(const std::string& path) {
  constexpr int kFlags = O_RDWR | O_CREAT | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC;
  Descriptor file(open(path.c_str(), kFlags, kOwnerOnly));
  if (!file && errno == ELOOP) return {Descriptor(), "it is a symbolic link, not a regular file"};
  if (!file) return {Descriptor(), std::strerror(errno)};
  if (std::string fault = faultOfKind(file); !fault.empty()) return {Descriptor(), std::move(fault)};
  if (!keepFromOthers(file)) return {Descriptor(), std::strerror(errno)};
  return {std::move(file), {}};
}

LockResult lockFile(const Descriptor& file, std::chrono::milliseconds limit) {
  for (auto left = limit; flock(file.number(), LOCK_EX | LOCK_NB) != 0; left -= kLockInterval) {
    if (errno != EWOULDBLOCK && errno != EINTR) return LockResult::kNoLocks;
    if (left < kLockInterval) return LockResult::kHeld;
    std::this_thread::sleep_for(kLockInterval);
  }
  return LockResult::kLocked;
}

OpenedFile lockBeside(const std::string& file, WithoutLocks without) {
  const std::string path = file + ".lock";
  OpenedFile opened = openPrivateFile(path);
  if (!opened.file) {
    return {Descriptor(), "'" + path + "' cannot be opened: " + opened.fault +
                              "; remove it, and let the program write to its folder"};
  }
  const LockResult result = lockFile(opened.file);
  if (result == LockResult::kHeld) return {Descriptor(), lockFault(path)};
  if (result == LockResult::kNoLocks && without == WithoutLocks::kRefuse)
    return {Descriptor(), "the file system of '" + path + "' has no locks; name a file in another one"};
  return opened;
}

std::string lockFault(const std::string& path) {
  return "another program holds the lock on '" + path + "'; end that program or remove the file";
}

std::variant<std::string, ParseError> KeptFile::read() const {
  if (path_.empty()) return std::string();
  auto content = readTextFile(path_.string(), maxBytes_);
  const auto* const text = std::get_if<std::string>(&content);
  if (text != nullptr && text->size() > maxBytes_)
    return ParseError{"it has more than " + std::to_string(maxBytes_) + " bytes"};
  std::error_code ignored;
  const bool missing = std::filesystem::status(path_, ignored).type() == std::filesystem::file_type::not_found;
  return text == nullptr && missing ? std::string() : std::move(content);
}

std::string KeptFile::change(const Edit& edit, FileReplacement::Wait wait) const {
  if (path_.empty()) return {};
  std::error_code ignored;  // locking reports the error
  std::filesystem::create_directories(folderOf(path_), ignored);
  const OpenedFile lock = lockBeside(path_.string(), WithoutLocks::kGoOn);
  if (!lock.file) return lock.fault;
  const auto before = read();
  if (const auto* error = std::get_if<ParseError>(&before)) return error->what;
  FileReplacement replacement(path_.string());
  replacement.write(edit(std::get<std::string>(before)));
  return replacement.finish(wait, FileReplacement::Readers::kOwner);
}

}  // namespace platon
