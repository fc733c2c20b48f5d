#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "server/admin/console_reply.h"
#include "server/admin/console_socket.h"
#include "server/base/line_buffer.h"
#include "server/net/time_point.h"

namespace platon {

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

}  // namespace platon
