#pragma once

#include <cstddef>
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "protocol/files/descriptor.h"
#include "server/admin/console.h"
#include "server/base/time_point.h"

namespace platon {

/// Cuts a stream of bytes into lines of bounded length.
class LineBuffer {
 public:
  /// `maxBytes`: longest line, without its line feed.
  explicit LineBuffer(std::size_t maxBytes) : maxBytes_(maxBytes) {}

  void add(std::string_view bytes) { bytes_ += bytes; }
  /// The next complete line without its line feed and a carriage return before it. Nothing while it is incomplete, and
  /// once a line is too long.
  std::optional<std::string> next();
  /// Whether `next` returns a line.
  bool ready() const;
  /// Whether the next line is too long, complete or not.
  bool tooLong() const;

 private:
  std::size_t maxBytes_;
  std::string bytes_;
};

/// Where the console of a server listens if no path is given: in the user's folder for such files, or else in /tmp.
/// `runtimeFolder`: value of XDG_RUNTIME_DIR; null or empty: not set.
std::string defaultConsolePath(const char* runtimeFolder, unsigned user);
/// The same for this process.
std::string defaultConsolePath();

/// Throws ProgramError (kUsage) if no console can be opened at the path, whether another server uses it or not. Opens
/// and removes nothing.
void checkConsolePath(const std::string& path);

/// A Unix socket that listens at a path and that only its user can connect to. The destructor removes it.
class ConsoleSocket {
 public:
  /// Replaces the socket of a server that no longer runs. Throws ProgramError: kFailed if a server listens there,
  /// kUsage if the path is another kind of file or if no socket can be made there.
  explicit ConsoleSocket(std::string path);
  ~ConsoleSocket();
  ConsoleSocket(const ConsoleSocket&) = delete;
  ConsoleSocket& operator=(const ConsoleSocket&) = delete;

  const std::string& path() const { return path_; }
  const Descriptor& listener() const { return listener_; }

 private:
  void replaceStale() const;
  bool bindAndListen();

  std::string path_;
  Descriptor listener_;
  // Tells whether the file at the path is still this socket.
  unsigned long long device_ = 0;
  unsigned long long inode_ = 0;
};

/// The server's end of all consoles: reads commands from a Unix socket and sends the replies. Never waits.
class ConsoleServer {
 public:
  /// Most consoles at a time. One more replaces the console that has been silent longest.
  static constexpr std::size_t kMaxConsoles = 8;
  /// A console that does not read its reply for this time is dropped.
  static constexpr std::chrono::seconds kReadTime{5};

  /// Listens at the path. Throws ProgramError like ConsoleSocket.
  explicit ConsoleServer(std::string path) : socket_(std::move(path)) {}

  using Execute = std::function<ConsoleReply(std::string_view line)>;
  /// Accepts consoles, executes at most one command of each, and sends what they take.
  void poll(TimePoint now, const Execute& execute);

  const std::string& path() const { return socket_.path(); }
  std::size_t consoles() const { return consoles_.size(); }

 private:
  struct Console {
    Descriptor socket;
    LineBuffer lines;
    std::string output;  // not sent yet
    TimePoint activeAt;  // when it last sent or took something
    bool closing = false;
  };

  void accept(TimePoint now);
  static void serve(Console& console, TimePoint now, const Execute& execute);
  static void executeNext(Console& console, TimePoint now, const Execute& execute);
  static void receive(Console& console, TimePoint now);

  ConsoleSocket socket_;
  std::vector<Console> consoles_;
};

/// Where the console takes its commands from and writes to.
struct ConsoleTerminal {
  std::istream& commands;
  std::ostream& results;
  std::ostream& talk;        ///< errors and the prompt
  bool interactive = false;  ///< a person types: show a prompt
};

/// Sends each line to the server that listens at the path and prints its reply, until the commands end or one of them
/// is `quit`. Empty lines and lines that begin with `#` are skipped. Returns the exit code: 0, or 1 if a command failed
/// or the server did not answer.
int runConsole(const std::string& path, const ConsoleTerminal& terminal);

}  // namespace platon
