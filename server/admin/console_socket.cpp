#include "server/admin/console_socket.h"

#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <utility>

#include "protocol/program_error.h"
#include "server/admin/stream_socket.h"

namespace platon {
namespace {

constexpr int kConsoleBacklog = 8;
constexpr mode_t kOwnerOnly = S_IRUSR | S_IWUSR;

[[noreturn]] void refuse(const std::string& path, const std::string& why, int exitCode = ProgramError::kUsage) {
  throw ProgramError(exitCode,
                     "cannot open the console at '" + path + "': " + why + "; name another path after --socket");
}

int exitCodeOf(int fault) { return fault == EADDRINUSE ? ProgramError::kFailed : ProgramError::kUsage; }

void refuseOtherKind(const std::string& path) {
  struct stat status {};
  if (lstat(path.c_str(), &status) == 0 && !S_ISSOCK(status.st_mode)) refuse(path, "it is a file of another kind");
}

}  // namespace

std::string defaultConsolePath(const char* runtimeFolder, unsigned user) {
  if (runtimeFolder && *runtimeFolder != '\0') return std::string(runtimeFolder) + "/platon-server.sock";
  return "/tmp/platon-server-" + std::to_string(user) + ".sock";
}

std::string defaultConsolePath() { return defaultConsolePath(std::getenv("XDG_RUNTIME_DIR"), getuid()); }

void checkConsolePath(const std::string& path) {
  if (path.size() >= sizeof(sockaddr_un::sun_path)) {
    refuse(path, "the path has more than " + std::to_string(sizeof(sockaddr_un::sun_path) - 1) + " bytes");
  }
  refuseOtherKind(path);
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  if (access(folder.empty() ? "." : folder.c_str(), W_OK | X_OK) != 0) refuse(path, std::strerror(errno));
}

ConsoleSocket::ConsoleSocket(std::string path) : path_(std::move(path)) {
  checkConsolePath(path_);
  if (!bindAndListen() && errno == EADDRINUSE) {
    replaceStale();
    bindAndListen();
  }
  if (!listener_) refuse(path_, std::strerror(errno), exitCodeOf(errno));
  struct stat status {};
  if (lstat(path_.c_str(), &status) != 0) refuse(path_, std::strerror(errno));
  device_ = status.st_dev;
  inode_ = status.st_ino;
}

ConsoleSocket::~ConsoleSocket() {
  struct stat status {};
  const bool ours = lstat(path_.c_str(), &status) == 0 && status.st_dev == device_ && status.st_ino == inode_;
  if (ours) unlink(path_.c_str());
}

// The mode is set before the file exists, so that nobody else can connect in between.
bool ConsoleSocket::bindAndListen() {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  path_.copy(address.sun_path, path_.size());
  Descriptor socket(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  const bool listens = socket && fchmod(socket.number(), kOwnerOnly) == 0 &&
                       bind(socket.number(), reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0 &&
                       listen(socket.number(), kConsoleBacklog) == 0;
  if (listens) listener_ = std::move(socket);
  return listens;
}

void ConsoleSocket::replaceStale() const {
  refuseOtherKind(path_);
  const Descriptor other = connectUnix(path_);
  if (other || errno == EAGAIN) refuse(path_, "another server uses it", exitCodeOf(EADDRINUSE));
  if (errno != ECONNREFUSED || unlink(path_.c_str()) != 0) refuse(path_, std::strerror(errno));
}

}  // namespace platon
