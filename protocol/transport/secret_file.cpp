#include "protocol/transport/secret_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>

#include "protocol/program_error.h"

namespace platon {
namespace {

[[noreturn]] void refuse(const std::string& path, const std::string& why) {
  throw ProgramError(ProgramError::kUsage, path + ": error: " + why);
}

std::string firstLine(const std::string& path) {
  errno = 0;
  std::ifstream file(path);
  std::string line;
  if (!file) refuse(path, std::strerror(errno));
  std::getline(file, line);
  if (file.bad()) refuse(path, "cannot be read");
  if (!line.empty() && line.back() == '\r') line.pop_back();
  return line;
}

void create(const std::string& path, const std::string& line) {
  const int handle = open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, S_IRUSR | S_IWUSR);
  if (handle < 0) refuse(path, std::string("cannot be created: ") + std::strerror(errno));
  const std::string text = line + "\n";
  const bool written = write(handle, text.data(), text.size()) == static_cast<ssize_t>(text.size());
  const int fault = errno;
  close(handle);
  if (!written) refuse(path, std::string("cannot be written: ") + std::strerror(fault));
}

}  // namespace

std::string readPasswordFile(const std::string& path) {
  const std::string password = firstLine(path);
  if (password.empty()) refuse(path, "the first line must be the password");
  return password;
}

ServerIdentity readKeyFile(const std::string& path) {
  if (access(path.c_str(), F_OK) != 0 && errno == ENOENT) {
    const ServerIdentity identity = ServerIdentity::random();
    create(path, identity.text());
    return identity;
  }
  const std::optional<ServerIdentity> identity = ServerIdentity::parse(firstLine(path));
  if (!identity) refuse(path, "not a key of platon-server; name a file that does not exist to have one made");
  return *identity;
}

}  // namespace platon
