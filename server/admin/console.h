#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "server/admin/ban_store.h"
#include "server/admin/console_command.h"
#include "server/admin/console_reply.h"
#include "server/base/utc_time.h"
#include "server/match/match.h"

namespace platon {

/// What the console needs of the program around it.
struct ConsoleProgram {
  std::function<std::string()> status;  ///< lines about the server, before those about the match
  std::function<ConsoleReply()> reload;
  std::function<void()> stop;                                ///< only requests the end
  std::function<ConsoleReply(const DrainCommand&)> drain{};  ///< begins to drain
  std::function<void(std::string_view)> log;                 ///< gets each line that has changed something
};

/// Executes the commands of the console on a match and a list of bans.
class Console {
 public:
  /// Most bans that the command `bans` lists.
  static constexpr std::size_t kMaxBansListed = 200;

  /// All of the arguments must outlive the console.
  Console(Match& match, BanStore& bans, ConsoleProgram program)
      : match_(match), bans_(bans), program_(std::move(program)) {}

  ConsoleReply execute(std::string_view line, UtcTime now);

 private:
  ConsoleReply run(const StatusCommand&, UtcTime) const;
  ConsoleReply run(const PlayersCommand&, UtcTime) const;
  ConsoleReply run(const KickCommand& command, UtcTime) const;
  ConsoleReply run(const BanCommand& command, UtcTime now) const;
  ConsoleReply run(const UnbanCommand& command, UtcTime now) const;
  ConsoleReply run(const BansCommand&, UtcTime now) const;
  ConsoleReply run(const MuteCommand& command, UtcTime) const;
  ConsoleReply run(const SayCommand& command, UtcTime) const;
  ConsoleReply run(const NextCommand&, UtcTime) const;
  ConsoleReply run(const ReloadCommand&, UtcTime) const { return program_.reload(); }
  ConsoleReply run(const DrainCommand& command, UtcTime) const { return program_.drain(command); }
  ConsoleReply run(const StopCommand&, UtcTime) const;
  ConsoleReply run(const HelpCommand&, UtcTime) const;

  std::variant<PlayerStatus, ParseError> find(const PlayerWord& word) const;
  std::variant<AddressRange, ParseError> rangeOf(const PlayerWord& word) const;

  Match& match_;
  BanStore& bans_;
  ConsoleProgram program_;
};

}  // namespace platon
