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

// Locks `file`.lock, a private file, since the file itself is replaced when it is written. On failure why, and how to
// mend it. The lock lasts as long as the file is open.
OpenedFile lockBeside(const std::string& file, bool needsLocks) {
  const std::string path = file + ".lock";
  OpenedFile opened = openPrivateFile(path);
  if (!opened.file) {
    return {Descriptor(), "'" + path + "' cannot be opened: " + opened.fault +
                              "; remove it, and let the program write to its folder"};
  }
  const LockResult result = lockFile(opened.file);
  if (result == LockResult::kHeld)
    return {Descriptor(), "another program holds the lock on '" + path + "'; end that program"};
  if (result == LockResult::kNoLocks && needsLocks)
    return {Descriptor(), "the file system of '" + path + "' has no locks; name a file in another file system"};
  return opened;
}

bool isLinkToNothing(const std::filesystem::path& path) {
  std::error_code ignored;
  return std::filesystem::is_symlink(path, ignored) &&
         std::filesystem::status(path, ignored).type() == std::filesystem::file_type::not_found;
}

FileReplacement::Readers readersOf(KeptFile::Kind kind) {
  using Readers = FileReplacement::Readers;
  if (kind == KeptFile::Kind::kOwn) return Readers::kOnlyOwner;
  return kind == KeptFile::Kind::kNamed ? Readers::kOwnerIfNew : Readers::kAllIfNew;
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

// The file is missing. Its folder is not, or will be made. Where a link leads to nothing, a new file would take the
// place of the link.
bool KeptFile::isMissing() const {
  std::error_code ignored;
  const bool hasFolder = kind_ == Kind::kOwn || std::filesystem::is_directory(folderOf(path_), ignored);
  return hasFolder && std::filesystem::symlink_status(path_, ignored).type() == std::filesystem::file_type::not_found;
}

std::string KeptFile::faultOf(const std::string& text, const char* verb) const {
  if (text.size() <= maxBytes_) return {};
  return "it " + std::string(verb) + " more than " + std::to_string(maxBytes_) +
         " bytes; remove lines that you do not need";
}

std::variant<std::string, ParseError> KeptFile::read() const {
  if (path_.empty() || isMissing()) return std::string();
  auto content = readTextFile(path_.string(), maxBytes_);
  if (auto* const error = std::get_if<ParseError>(&content)) {
    if (isLinkToNothing(path_)) error->what = "it is a symbolic link to a missing file";
    error->what += kind_ == Kind::kOwn ? "; make it readable or move it away"
                                       : "; name a file that can be read and written, in a folder that exists";
  } else if (std::string fault = faultOf(std::get<std::string>(content), "has"); !fault.empty()) {
    return ParseError{std::move(fault)};
  }
  return content;
}

// Of a link, the file to which it leads is replaced, so all that link to it share one lock.
std::string KeptFile::lockedFile() const {
  std::error_code error;
  const std::filesystem::path target = std::filesystem::canonical(path_, error);
  return !error && std::filesystem::is_regular_file(target, error) ? target.string() : path_.string();
}

std::string KeptFile::change(const Edit& edit, Wait wait) const {
  if (path_.empty()) return {};
  std::error_code error;
  if (kind_ == Kind::kOwn) std::filesystem::create_directories(folderOf(path_), error);
  if (error) return "its folder cannot be made: " + error.message() + "; make it, and let the program write to it";
  const OpenedFile lock = lockBeside(lockedFile(), kind_ == Kind::kPublished);
  const auto before = read();
  if (const auto* fault = std::get_if<ParseError>(&before)) return fault->what;
  if (!lock.file) return lock.fault;
  const auto after = edit(std::get<std::string>(before));
  if (const auto* fault = std::get_if<ParseError>(&after)) return fault->what;
  const auto& text = std::get<std::string>(after);
  if (text == std::get<std::string>(before)) return {};
  if (std::string fault = faultOf(text, "would have"); !fault.empty()) return fault;
  FileReplacement replacement(path_.string());
  replacement.write(text);
  return replacement.finish(wait, readersOf(kind_));
}

}  // namespace platon
