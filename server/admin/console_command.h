#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "protocol/files/parse_error.h"
#include "server/admin/address_range.h"

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

}  // namespace platon
