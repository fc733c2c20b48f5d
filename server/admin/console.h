#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "protocol/files/word_reader.h"
#include "server/admin/bans.h"
#include "server/base/utc_time.h"
#include "server/match/match.h"

namespace platon {

/// Longest line that the console of a server reads, bytes without the line feed.
inline constexpr std::size_t kMaxConsoleLineBytes = 512;
/// Longest reason of a kick, bytes: with the sentence around it, it fits kMaxReasonBytes.
inline constexpr std::size_t kMaxKickReasonBytes = 100;

/// Longest time for which a server can drain: a day.
inline constexpr std::chrono::seconds kMaxDrain{24 * 60 * 60};

/// A player, by the number or the name that the command `players` lists.
struct PlayerWord {
  std::string text;

  friend bool operator==(const PlayerWord&, const PlayerWord&) = default;
};

struct StatusCommand {
  friend bool operator==(const StatusCommand&, const StatusCommand&) = default;
};
struct PlayersCommand {
  friend bool operator==(const PlayersCommand&, const PlayersCommand&) = default;
};
struct KickCommand {
  PlayerWord player;
  std::string reason;  ///< a label of at most kMaxKickReasonBytes, perhaps empty

  friend bool operator==(const KickCommand&, const KickCommand&) = default;
};
struct BanCommand {
  std::variant<PlayerWord, AddressRange> target;
  std::optional<std::chrono::seconds> duration;  ///< nothing: for ever
  std::string reason;                            ///< as `parseBanReason` returns it, perhaps empty

  friend bool operator==(const BanCommand&, const BanCommand&) = default;
};
struct UnbanCommand {
  AddressRange range;

  friend bool operator==(const UnbanCommand&, const UnbanCommand&) = default;
};
struct BansCommand {
  friend bool operator==(const BansCommand&, const BansCommand&) = default;
};
struct MuteCommand {
  PlayerWord player;
  bool muted = true;

  friend bool operator==(const MuteCommand&, const MuteCommand&) = default;
};
struct SayCommand {
  std::string text;  ///< a label of at most kMaxReasonBytes

  friend bool operator==(const SayCommand&, const SayCommand&) = default;
};
struct NextCommand {
  friend bool operator==(const NextCommand&, const NextCommand&) = default;
};
struct ReloadCommand {
  friend bool operator==(const ReloadCommand&, const ReloadCommand&) = default;
};
struct DrainCommand {
  std::optional<std::chrono::seconds> limit;  ///< 1 s … kMaxDrain; nothing: that of the configuration
  std::string next;                           ///< isNextServer, or empty: that of the configuration

  friend bool operator==(const DrainCommand&, const DrainCommand&) = default;
};
struct StopCommand {
  friend bool operator==(const StopCommand&, const StopCommand&) = default;
};
struct HelpCommand {
  friend bool operator==(const HelpCommand&, const HelpCommand&) = default;
};

using ConsoleCommand =
    std::variant<StatusCommand, PlayersCommand, KickCommand, BanCommand, UnbanCommand, BansCommand, MuteCommand,
                 SayCommand, NextCommand, ReloadCommand, DrainCommand, StopCommand, HelpCommand>;

/// Reads a line of the console. The first word is the name of a command; a name of a player that contains spaces stands
/// in quotes. A line that is too long, or contains a control character, is refused.
std::variant<ConsoleCommand, ParseError> parseConsoleCommand(std::string_view line);

/// A command as the help lists it.
struct ConsoleCommandHelp {
  std::string_view name;
  std::string_view arguments;  ///< perhaps empty
  std::string_view meaning;
};

/// All commands, in the order of the help.
std::span<const ConsoleCommandHelp> consoleCommands();

/// What the server answers to a command of the console.
struct ConsoleReply {
  bool ok = true;
  std::string text;  ///< lines, perhaps none; each but the last ends with a line feed, and the first is not empty

  friend bool operator==(const ConsoleReply&, const ConsoleReply&) = default;
};

/// The reply as it is sent: each line of the text after a space, then a line `ok` or `failed`.
std::string encode(const ConsoleReply& reply);

/// Puts replies together from the lines that arrive. Whoever has sent them, the texts can be printed on a terminal: '?'
/// takes the place of control characters, marks that change the direction of writing, and bytes that are no UTF-8.
class ConsoleReplyReader {
 public:
  /// Adds a line, without its line feed. Returns the reply with the line that completes it.
  std::optional<ConsoleReply> add(std::string_view line);

 private:
  ConsoleReply reply_;
};

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
