#include "protocol/transport/secret_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string_view>

#include "protocol/program_error.h"

namespace platon {
namespace {

[[noreturn]] void refuse(const std::string& path, const std::string& why) {
  throw ProgramError(ProgramError::kUsage, path + ": error: " + why);
}

[[noreturn]] void refuseToRead(const std::string& path, int fault) {
  refuse(path, std::string(std::strerror(fault)) + "; name a readable file");
}

[[noreturn]] void refuseToCreate(const std::string& path, int fault) {
  refuse(path, std::string("cannot be created: ") + std::strerror(fault) + "; name a file in a writable folder");
}

std::string firstLine(const std::string& path) {
  errno = 0;
  std::ifstream file(path);
  std::string line;
  if (!file) refuseToRead(path, errno);
  std::getline(file, line);
  if (file.bad()) refuseToRead(path, errno);
  if (!line.empty() && line.back() == '\r') line.pop_back();
  return line;
}

bool writeAll(int handle, std::string_view text) {
  while (!text.empty()) {
    const ssize_t count = write(handle, text.data(), text.size());
    if (count < 0) return false;
    text.remove_prefix(static_cast<std::size_t>(count));
  }
  return fsync(handle) == 0;
}

// Makes the file with its whole content or not at all: when the disk is full, nothing is left that a later start would
// take for a damaged key. Never replaces a file.
void create(const std::string& path, const std::string& line) {
  std::string part = path + ".XXXXXX";
  const int handle = mkostemp(part.data(), O_CLOEXEC);  // readable only by the owner
  if (handle < 0) refuseToCreate(path, errno);
  const bool written = writeAll(handle, line + "\n");
  const bool created = written && link(part.c_str(), path.c_str()) == 0;
  const int fault = errno;
  close(handle);
  unlink(part.c_str());
  if (!written) refuse(path, std::string("cannot be written: ") + std::strerror(fault) + "; make room on the disk");
  if (!created) refuseToCreate(path, fault);
}

// Nothing if there is no file.
std::optional<ServerIdentity> findIdentity(const std::string& path) {
  if (access(path.c_str(), F_OK) != 0 && errno == ENOENT) return std::nullopt;
  std::optional<ServerIdentity> identity = ServerIdentity::parse(firstLine(path));
  if (!identity) refuse(path, "not a key of platon-server; name a file that does not exist to have one made");
  return identity;
}

}  // namespace

std::string readPasswordFile(const std::string& path) {
  const std::string password = firstLine(path);
  if (password.empty()) refuse(path, "the first line is empty; write the password there");
  return password;
}

ServerIdentity readKeyFile(const std::string& path) {
  if (const std::optional<ServerIdentity> found = findIdentity(path)) return *found;
  const ServerIdentity identity = ServerIdentity::random();
  create(path, identity.text());
  return identity;
}

bool checkKeyFile(const std::string& path) {
  if (findIdentity(path)) return true;
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  if (access(folder.empty() ? "." : folder.c_str(), W_OK | X_OK) != 0) refuseToCreate(path, errno);
  return false;
}

}  // namespace platon
