#include "server/admin/console_client.h"

#include <poll.h>

#include <cerrno>
#include <cstring>
#include <istream>
#include <optional>
#include <ostream>

#include "server/admin/console_command.h"
#include "server/admin/console_reply.h"
#include "server/admin/stream_socket.h"
#include "server/base/line_buffer.h"

namespace platon {
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
    return fail(terminal, "the server at '" + path +
                              "' belongs to another user; name the socket of your own after --socket, or run the "
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
    if (!reply) return fail(terminal, "the server at '" + path + "' has ended or does not answer");
    print(terminal, *reply);
    failed = failed || !reply->ok;
  }
  return failed ? 1 : 0;
}

}  // namespace platon
