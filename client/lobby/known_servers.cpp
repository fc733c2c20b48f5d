#include "client/lobby/known_servers.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include "protocol/program_error.h"
#include "protocol/transport/server_identity.h"

namespace platon {
namespace {

struct KnownServer {
  std::string address;
  CryptoKey key;
};

bool isAddress(const std::string& text) {
  try {
    return parseServerAddress(text).text() == text;
  } catch (const std::invalid_argument&) {
    return false;
  }
}

// Nothing if the line is damaged.
std::optional<KnownServer> parse(const std::string& line) {
  std::istringstream words(line);
  std::string address;
  std::string key;
  std::string more;
  if (!(words >> address >> key) || words >> more || !isAddress(address)) return std::nullopt;
  const std::optional<CryptoKey> parsed = keyOf(key);
  return parsed ? std::optional(KnownServer{address, *parsed}) : std::nullopt;
}

bool isSkipped(const std::string& line) {
  const std::size_t first = line.find_first_not_of(" \t\r");
  return first == std::string::npos || line[first] == '#';
}

[[noreturn]] void refuse(const std::string& place, const std::string& why) {
  throw ProgramError(ProgramError::kUsage, place + ": error: " + why);
}

// A file that no other client changes meanwhile. Where the file system has no locks, it is not locked.
class LockedFile {
 public:
  explicit LockedFile(const std::filesystem::path& path)
      : handle_(open(path.c_str(), O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC, S_IRUSR | S_IWUSR | S_IRGRP | S_IROTH)) {
    while (handle_ >= 0 && flock(handle_, LOCK_EX) != 0 && errno == EINTR) {
    }
  }
  ~LockedFile() {
    if (handle_ >= 0) close(handle_);
  }
  LockedFile(const LockedFile&) = delete;
  LockedFile& operator=(const LockedFile&) = delete;

  // Adds the whole text or, on a full disk, nothing.
  void append(std::string_view text) const {
    struct stat before {};
    if (handle_ < 0 || fstat(handle_, &before) != 0) return;
    const ssize_t count = write(handle_, text.data(), text.size());
    if (count >= 0 && static_cast<std::size_t>(count) == text.size()) return;
    (void)!ftruncate(handle_, before.st_size);
  }

 private:
  int handle_;
};

}  // namespace

std::string KnownServers::read() const {
  std::error_code ignored;
  if (std::filesystem::status(file_, ignored).type() == std::filesystem::file_type::not_found) return {};
  errno = 0;
  std::ifstream file(file_);
  std::ostringstream text;
  if (file.peek() != std::ifstream::traits_type::eof()) text << file.rdbuf();
  if (!file.is_open() || file.bad() || text.fail()) {
    refuse(file_.string(), std::string(std::strerror(errno)) + "; make the file of the known servers readable");
  }
  return text.str();
}

std::optional<CryptoKey> KnownServers::findIn(const std::string& text, const ServerAddress& server) const {
  std::optional<CryptoKey> found;
  std::istringstream lines(text);
  int number = 1;
  for (std::string line; std::getline(lines, line); ++number) {
    if (isSkipped(line)) continue;
    const std::optional<KnownServer> known = parse(line);
    if (!known) {
      refuse(file_.string() + ":" + std::to_string(number),
             "damaged line, expected HOST:PORT KEY; correct or remove it. The key of a server without a line is "
             "stored again when you join");
    }
    if (!found && known->address == server.text()) found = known->key;
  }
  return found;
}

std::optional<CryptoKey> KnownServers::find(const ServerAddress& server) const { return findIn(read(), server); }

void KnownServers::remember(const ServerAddress& server, const CryptoKey& key) const {
  if (file_.empty()) return;
  std::error_code ignored;  // the file cannot be opened then
  std::filesystem::create_directories(file_.parent_path(), ignored);
  const LockedFile file(file_);
  std::string text;
  try {
    text = read();
    if (findIn(text, server)) return;
  } catch (const ProgramError&) {
    return;  // `find` has told the player, or will at the next start
  }
  file.append((text.empty() || text.ends_with('\n') ? "" : "\n") + server.text() + " " + textOf(key) + "\n");
}

}  // namespace platon
