#include "protocol/files/text_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>

namespace platon {
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

enum class Wait { kForDisk, kNot };

std::string replaceFile(const std::string& path, std::string_view content, Wait wait, mode_t rights = kOwnRights) {
  std::error_code missing;
  const std::filesystem::path linked = std::filesystem::canonical(path, missing);
  const std::string target = missing ? path : linked.string();
  if (std::string fault = faultOfKind(target); !fault.empty()) return fault;
  std::string temporary = temporaryBeside(target);
  const Descriptor file(mkstemp(temporary.data()));
  if (!file) return std::strerror(errno);
  const bool waits = wait == Wait::kForDisk;
  const bool replaced = writeAll(file, content) && takeRights(file, target, rights) &&
                        (!waits || fsync(file.number()) == 0) && std::rename(temporary.c_str(), target.c_str()) == 0;
  const int fault = errno;
  if (replaced) return !waits || syncFolder(target) ? std::string() : std::strerror(errno);
  unlink(temporary.c_str());
  return std::strerror(fault);
}

}  // namespace

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
  return replaceFile(path, content, Wait::kForDisk);
}

std::string replacePublicFile(const std::string& path, std::string_view content) {
  return replaceFile(path, content, Wait::kForDisk, kPublicRights);
}

std::string replaceCachedFile(const std::string& path, std::string_view content) {
  return replaceFile(path, content, Wait::kNot);
}

std::string replaceOutputFile(const std::string& path, std::string_view content) {
  return replaceFile(path, content, Wait::kNot, kPublicRights);
}

}  // namespace platon
