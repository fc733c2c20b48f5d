// The half of text_file.h that replaces files. Debian's C library for WebAssembly has nothing for it.

#include "protocol/files/text_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
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

// Gives the new file owner and access rights of the old one, if there is one. The owner stays the user's where that is
// not allowed.
bool takeRights(const Descriptor& file, const std::string& old, FileReplacement::Readers readers) {
  using Readers = FileReplacement::Readers;
  struct stat status {};
  if (stat(old.c_str(), &status) != 0) return fchmod(file.number(), readers == Readers::kAllIfNew ? 0644 : 0600) == 0;
  if (fchown(file.number(), status.st_uid, status.st_gid) != 0 && errno != EPERM) return false;
  return fchmod(file.number(), status.st_mode & (readers == Readers::kOnlyOwner ? 0700 : 07777)) == 0;
}

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
  const bool replaced = takeRights(file_, target_, readers) && (!waits || fsync(file_.number()) == 0) &&
                        std::rename(temporary_.c_str(), target_.c_str()) == 0;
  if (!replaced) return fault_ = std::strerror(errno);
  file_ = Descriptor();
  return !waits || syncFolder(target_) ? std::string() : std::strerror(errno);
}

std::string folderOf(const std::string& file) {
  const std::size_t slash = file.rfind('/');
  if (slash == std::string::npos) return ".";
  return file.substr(0, std::max<std::size_t>(slash, 1));
}

bool syncFolder(const std::string& file) {
  const Descriptor opened(open(folderOf(file).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  return opened && (fsync(opened.number()) == 0 || errno == EINVAL);
}

std::string replaceTextFile(const std::string& path, std::string_view content) {
  return replaceFile(path, content, FileReplacement::Wait::kForDisk, FileReplacement::Readers::kOwnerIfNew);
}

std::string replaceCachedFile(const std::string& path, std::string_view content) {
  return replaceFile(path, content, FileReplacement::Wait::kNot, FileReplacement::Readers::kOwnerIfNew);
}

std::string replaceOutputFile(const std::string& path, std::string_view content) {
  return replaceFile(path, content, FileReplacement::Wait::kNot, FileReplacement::Readers::kAllIfNew);
}

}  // namespace platon
