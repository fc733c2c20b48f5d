#include "protocol/files/text_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
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

std::variant<std::string, ParseError> readTextFile(const std::string& path, std::size_t maxBytes, Pipes pipes) {
  const OpenedFile opened = openToRead(path, pipes);
  if (!opened.file) return ParseError{opened.fault};
  std::string content;
  if (!readUpTo(opened.file, maxBytes + 1, content)) return ParseError{std::strerror(errno)};
  return content;
}

}  // namespace platon
