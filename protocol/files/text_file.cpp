#include "protocol/files/text_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <utility>

namespace platon {
namespace {

constexpr const char* kSocketFault = "it is a socket, not a regular file";

std::string faultOf(const struct stat& status) {
  if (S_ISREG(status.st_mode)) return {};
  if (S_ISDIR(status.st_mode)) return std::strerror(EISDIR);
  if (S_ISFIFO(status.st_mode)) return "it is a pipe, not a regular file";
  return S_ISSOCK(status.st_mode) ? kSocketFault : "it is a device, not a regular file";
}

bool isPipe(const Descriptor& file) {
  struct stat status {};
  return fstat(file.number(), &status) == 0 && S_ISFIFO(status.st_mode);
}

// Without it a read that finds a pipe empty would fail instead of waiting.
bool letReadsWait(const Descriptor& file) { return fcntl(file.number(), F_SETFL, 0) == 0; }

}  // namespace

std::string faultOfKind(const std::string& path) {
  struct stat status {};
  return stat(path.c_str(), &status) == 0 ? faultOf(status) : std::string();
}

std::string faultOfKind(const Descriptor& file) {
  struct stat status {};
  return fstat(file.number(), &status) == 0 ? faultOf(status) : std::strerror(errno);
}

// A named pipe that is opened with O_NONBLOCK does not wait for its other end.
OpenedFile openToRead(const std::string& path, Pipes pipes) {
  Descriptor file(open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
  if (!file) return {Descriptor(), errno == ENXIO ? kSocketFault : std::strerror(errno)};
  if (pipes == Pipes::kRead && isPipe(file) && letReadsWait(file)) return {std::move(file), {}};
  if (std::string fault = faultOfKind(file); !fault.empty()) return {Descriptor(), std::move(fault)};
  return {std::move(file), {}};
}

std::optional<std::size_t> readNext(const Descriptor& file, void* bytes, std::size_t count) {
  std::size_t got = 0;
  while (got < count) {
    const ssize_t now = read(file.number(), static_cast<char*>(bytes) + got, count - got);
    if (now < 0 && errno != EINTR) return std::nullopt;
    if (now == 0) break;
    if (now > 0) got += static_cast<std::size_t>(now);
  }
  return got;
}

namespace {

bool writeAll(const Descriptor& file, std::string_view content) {
  while (!content.empty()) {
    const ssize_t written = write(file.number(), content.data(), content.size());
    if (written < 0 && errno != EINTR) return false;
    if (written > 0) content.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

// Gives the new file owner and access rights of the old one, or `rights` if there is none. The owner stays the user's
// where that is not allowed.
bool takeRights(const Descriptor& file, const std::string& old, mode_t rights) {
  struct stat status {};
  if (stat(old.c_str(), &status) != 0) return fchmod(file.number(), rights) == 0;
  if (fchown(file.number(), status.st_uid, status.st_gid) != 0 && errno != EPERM) return false;
  return fchmod(file.number(), status.st_mode & 07777) == 0;
}

constexpr mode_t kOwnRights = 0600;
constexpr mode_t kPublicRights = 0644;

// The beginning of the name for a new file beside `target`; a name has at most 255 bytes.
std::string temporaryBeside(const std::string& target) {
  constexpr std::size_t kMaxBytes = 240;
  return target.substr(0, target.rfind('/') + 1 + kMaxBytes) + ".XXXXXX";
}

std::string replaceFile(const std::string& path, std::string_view content, FileReplacement::Wait wait,
                        FileReplacement::Readers readers) {
  FileReplacement replacement(path);
  replacement.write(content);
  return replacement.finish(wait, readers);
}

}  // namespace

FileReplacement::FileReplacement(const std::string& path) {
  std::error_code missing;
  const std::filesystem::path linked = std::filesystem::canonical(path, missing);
  target_ = missing ? path : linked.string();
  fault_ = faultOfKind(target_);
  if (!fault_.empty()) return;
  temporary_ = temporaryBeside(target_);
  file_ = Descriptor(mkstemp(temporary_.data()));
  if (!file_) fault_ = std::strerror(errno);
}

FileReplacement::~FileReplacement() {
  if (file_) unlink(temporary_.c_str());
}

void FileReplacement::write(std::string_view content) {
  if (fault_.empty() && !writeAll(file_, content)) fault_ = std::strerror(errno);
}

std::string FileReplacement::finish(Wait wait, Readers readers) {
  if (!fault_.empty()) return fault_;
  const bool waits = wait == Wait::kForDisk;
  const bool replaced = takeRights(file_, target_, readers == Readers::kAll ? kPublicRights : kOwnRights) &&
                        (!waits || fsync(file_.number()) == 0) && std::rename(temporary_.c_str(), target_.c_str()) == 0;
  if (!replaced) return fault_ = std::strerror(errno);
  file_ = Descriptor();
  return !waits || syncFolder(target_) ? std::string() : std::strerror(errno);
}

std::filesystem::path folderOf(const std::filesystem::path& file) {
  return file.has_parent_path() ? file.parent_path() : ".";
}

bool syncFolder(const std::filesystem::path& file) {
  const Descriptor opened(open(folderOf(file).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  return opened && (fsync(opened.number()) == 0 || errno == EINVAL);
}

std::variant<std::string, ParseError> readTextFile(const std::string& path, std::size_t maxBytes, Pipes pipes) {
  const OpenedFile opened = openToRead(path, pipes);
  if (!opened.file) return ParseError{opened.fault};
  std::string content;
  if (!readUpTo(opened.file, maxBytes + 1, content)) return ParseError{std::strerror(errno)};
  return content;
}

std::string replaceTextFile(const std::string& path, std::string_view content) {
  return replaceFile(path, content, FileReplacement::Wait::kForDisk, FileReplacement::Readers::kOwner);
}

std::string replacePublicFile(const std::string& path, std::string_view content) {
  return replaceFile(path, content, FileReplacement::Wait::kForDisk, FileReplacement::Readers::kAll);
}

std::string replaceCachedFile(const std::string& path, std::string_view content) {
  return replaceFile(path, content, FileReplacement::Wait::kNot, FileReplacement::Readers::kOwner);
}

std::string replaceOutputFile(const std::string& path, std::string_view content) {
  return replaceFile(path, content, FileReplacement::Wait::kNot, FileReplacement::Readers::kAll);
}

}  // namespace platon
