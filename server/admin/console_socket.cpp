#include "server/admin/console_socket.h"

#include <poll.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <istream>
#include <optional>
#include <ostream>
#include <utility>

#include "protocol/program_error.h"
#include "server/admin/console.h"
#include "server/admin/stream_socket.h"

namespace platon {

std::optional<std::string> LineBuffer::next() {
  if (!ready()) return std::nullopt;
  const std::size_t end = bytes_.find('\n');
  std::string line = bytes_.substr(0, end);
  bytes_.erase(0, end + 1);
  if (line.ends_with('\r')) line.pop_back();
  return line;
}

bool LineBuffer::ready() const { return bytes_.find('\n') <= maxBytes_; }

bool LineBuffer::tooLong() const { return std::min(bytes_.find('\n'), bytes_.size()) > maxBytes_; }

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
  if (lstat(path.c_str(), &status) == 0 && !S_ISSOCK(status.st_mode)) refuse(path, "it is not a socket");
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

void ConsoleServer::poll(TimePoint now, const Execute& execute) {
  accept(now);
  for (Console& console : consoles_) serve(console, now, execute);
  std::erase_if(consoles_, [](const Console& console) { return !console.socket; });
}

// At most one in each call, so that programs that connect again and again cannot hold up the server.
void ConsoleServer::accept(TimePoint now) {
  Descriptor socket = acceptFrom(socket_.listener());
  if (!socket || !peerIsTrusted(socket)) return;
  if (consoles_.size() == kMaxConsoles) {
    consoles_.erase(std::min_element(consoles_.begin(), consoles_.end(),
                                     [](const Console& a, const Console& b) { return a.activeAt < b.activeAt; }));
  }
  consoles_.push_back({std::move(socket), LineBuffer(kMaxConsoleLineBytes), {}, now});
}

// Nothing is read while a command or a reply waits, so that the memory of a console is bounded.
void ConsoleServer::serve(Console& console, TimePoint now, const Execute& execute) {
  if (console.output.empty() && !console.lines.ready()) receive(console, now);
  if (console.output.empty()) executeNext(console, now, execute);
  const std::size_t before = console.output.size();
  const bool broken = !sendTo(console.socket, console.output);
  if (console.output.size() < before) console.activeAt = now;
  const bool stuck = !console.output.empty() && now - console.activeAt > kReadTime;
  const bool done = console.closing && console.output.empty() && !console.lines.ready();
  if (broken || stuck || done) console.socket = Descriptor();
}

void ConsoleServer::executeNext(Console& console, TimePoint now, const Execute& execute) {
  if (const auto line = console.lines.next()) {
    console.output = encode(execute(*line));
    console.activeAt = now;
  } else if (console.lines.tooLong()) {
    console.output = encode(ConsoleReply{
        false, "the command has more than " + std::to_string(kMaxConsoleLineBytes) + " bytes; the console is closed"});
    console.closing = true;
    console.lines = LineBuffer(kMaxConsoleLineBytes);
  }
}

void ConsoleServer::receive(Console& console, TimePoint now) {
  Received received = receiveFrom(console.socket);
  if (!received.bytes.empty()) console.activeAt = now;
  console.lines.add(received.bytes);
  console.closing = console.closing || received.closed;
}

namespace {

constexpr int kAnswerTimeMs = 10'000;
// Longest line of a reply; the server's lines are shorter.
constexpr std::size_t kMaxReplyLineBytes = 64 * 1024;

/// A connection to a server, which answers one command at a time.
class ServerConnection {
 public:
  explicit ServerConnection(Descriptor socket) : socket_(std::move(socket)) {}

  // Nothing if the server does not answer.
  std::optional<ConsoleReply> ask(std::string line) {
    line += '\n';
    while (!line.empty()) {
      if (!sendTo(socket_, line) || (!line.empty() && !wait(POLLOUT))) return std::nullopt;
    }
    for (;;) {
      while (const auto next = lines_.next()) {
        if (const auto reply = reader_.add(*next)) return reply;
      }
      if (!wait(POLLIN)) return std::nullopt;
      const Received received = receiveFrom(socket_);
      lines_.add(received.bytes);
      if (received.closed || lines_.tooLong()) return std::nullopt;
    }
  }

 private:
  bool wait(short events) const {
    pollfd waiting{socket_.number(), events, 0};
    return ::poll(&waiting, 1, kAnswerTimeMs) > 0;
  }

  Descriptor socket_;
  LineBuffer lines_{kMaxReplyLineBytes};
  ConsoleReplyReader reader_;
};

int fail(const ConsoleTerminal& terminal, const std::string& what) {
  terminal.talk << "platon-server: " << what << '\n';
  return 1;
}

bool isSkipped(const std::string& line) {
  const std::size_t first = line.find_first_not_of(" \t");
  return first == std::string::npos || line[first] == '#';
}

bool isQuit(std::string line) {
  line.erase(line.find_last_not_of(" \t") + 1);
  return line == "quit" || line == "exit";
}

void print(const ConsoleTerminal& terminal, const ConsoleReply& reply) {
  std::ostream& stream = reply.ok ? terminal.results : terminal.talk;
  if (!reply.text.empty()) stream << (reply.ok ? "" : "error: ") << reply.text << '\n';
  stream.flush();
}

}  // namespace

int runConsole(const std::string& path, const ConsoleTerminal& terminal) {
  Descriptor socket = connectUnix(path);
  if (!socket) {
    const int error = errno;
    const std::string cause = error == EACCES
                                  ? "this user may not open it; run the console as the user of the server, or as root"
                                  : std::string("start one, or name its socket after --socket");
    return fail(terminal, "no server answers at '" + path + "' (" + std::strerror(error) + "); " + cause);
  }
  if (!listenerIsTrusted(socket, path)) {
    return fail(terminal,
                "the server at '" + path +
                    "' belongs to another user; name the socket of your own server after --socket, or run the "
                    "console as that user");
  }
  ServerConnection server(std::move(socket));
  bool failed = false;
  std::string line;
  const auto next = [&] {
    if (terminal.interactive) terminal.talk << "platon> " << std::flush;
    return static_cast<bool>(std::getline(terminal.commands, line)) && !isQuit(line);
  };
  while (next()) {
    if (isSkipped(line)) continue;
    const auto reply = server.ask(line);
    if (!reply)
      return fail(terminal, "the server at '" + path + "' has stopped or does not answer; its log may say why");
    print(terminal, *reply);
    failed = failed || !reply->ok;
  }
  return failed ? 1 : 0;
}

}  // namespace platon
