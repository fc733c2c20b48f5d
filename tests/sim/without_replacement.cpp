// For a C library without temporary files and rights, such as Debian's for WebAssembly: a file is written in place.

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "protocol/files/text_file.h"

namespace platon {

FileReplacement::FileReplacement(const std::string& path) : target_(path), fault_(faultOfKind(path)) {
  if (!fault_.empty()) return;
  file_ = Descriptor(open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644));
  if (!file_) fault_ = std::strerror(errno);
}

FileReplacement::~FileReplacement() = default;

void FileReplacement::write(std::string_view content) {
  while (fault_.empty() && !content.empty()) {
    const ssize_t written = ::write(file_.number(), content.data(), content.size());
    if (written < 0)
      fault_ = std::strerror(errno);
    else
      content.remove_prefix(static_cast<std::size_t>(written));
  }
}

std::string FileReplacement::finish(Wait, Readers) {
  file_ = Descriptor();
  return fault_;
}

}  // namespace platon
