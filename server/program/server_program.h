#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "protocol/files/file_watch.h"
#include "server/admin/announcement.h"
#include "server/admin/bans.h"
#include "server/admin/console.h"
#include "server/admin/console_socket.h"
#include "server/admin/drain.h"
#include "server/admin/metrics.h"
#include "server/app/dedicated_server.h"
#include "server/program/agones_link.h"
#include "server/program/command_line.h"
#include "server/service/service_manager.h"

namespace platon {

/// The dedicated server with the tools of its operator: console, bans and metrics.
class ServerProgram {
 public:
  using LogSink = std::function<void(std::string_view)>;

  /// Reads the files that the command line names, and opens all sockets. Throws ProgramError. Where the console cannot
  /// be opened at its default path, the server runs without one; `announce` logs why.
  ServerProgram(const CommandLine& line, const LogSink& sink) : ServerProgram(line, optionsOf(line), sink) {}
  ServerProgram(const ServerProgram&) = delete;
  ServerProgram& operator=(const ServerProgram&) = delete;

  /// Logs where server, console and metrics are reached.
  void announce();
  /// Serves until `stopRequested`, which is called before each step, returns true, or until the console stops it. Plays
  /// levels whose files have changed from the next round on, if they are valid. Returns whether the ban file holds all
  /// bans at the end; if not, it has logged why.
  bool run(const std::function<bool()>& stopRequested);
  /// Begins to drain if the options give it time, and otherwise stops at once. While it drains, stops it at once.
  void terminate();
  /// Reads configuration, levels and bans again. If anything is invalid, nothing changes. Returns what it has logged.
  ConsoleReply reload();
  /// Serves consoles and metrics. `run` calls it before each step while any are connected, and otherwise before the
  /// first step after 50 ms.
  void pollTools();

  DedicatedServer& server() { return server_; }
  const ServerOptions& options() const { return options_; }
  /// Address of the metrics; nothing if there are none.
  std::optional<SocketAddress> metricsAddress() const;
  /// The text that the metrics answer.
  std::string metricsText() const;

 private:
  ServerProgram(const CommandLine& line, const ServerOptions& options, const LogSink& sink);
  ServerProgram(const CommandLine& line, const ServerOptions& options, Log log);

  void openConsole();
  ConsoleProgram consoleProgram();
  void enterList();
  void leaveList();
  void logList(const std::optional<Announcement::Outcome>& outcome);
  ConsoleReply drain(const DrainCommand& command);
  bool hasDrained(TimePoint now);
  ConsoleReply readAgain();
  void pollLevels(TimePoint now);
  std::string takeOver(const ServerOptions& fresh);
  std::string status() const;
  void logBans(const std::optional<std::string>& fault);

  CommandLine line_;
  ServerOptions options_;  // as they are in effect
  BanStore bans_;
  FileWatch levelFiles_;
  DedicatedServer server_;
  Drain drain_{server_.match()};
  AgonesLink agones_;
  ServiceManager serviceManager_{ServiceManager::Environment::current()};
  std::optional<Announcement> announcement_;  // nothing: in no list
  Console console_;
  std::unique_ptr<ConsoleServer> consoleServer_;  // null: none
  std::string whyNoConsole_;
  std::unique_ptr<MetricsServer> metricsServer_;  // null: none
  TimePoint startedAt_;
  UtcTime startTime_ = utcNow();  // the same by the calendar
  TimePoint nextPollAt_{};
  bool bansUnwritten_ = false;  // the log says so
  bool stopping_ = false;
};

}  // namespace platon
