#include "server/admin/console_command.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include "platon/game/diagnostics.h"
#include "protocol/files/word_reader.h"
#include "protocol/label.h"
#include "protocol/limits.h"
#include "protocol/transport/server_address.h"
#include "server/admin/ban_list.h"
#include "server/base/utc_time.h"

namespace platon {
namespace {

using Result = std::variant<ConsoleCommand, ParseError>;

// Everything after the name of the command.
class Arguments {
 public:
  explicit Arguments(std::string_view text) : words_(text) {}

  bool empty() const { return words_.peek().empty(); }
  std::string_view peek() const { return words_.peek(); }
  std::string_view next() { return words_.next(); }
  std::string_view rest() const { return words_.rest(); }

  // A word, or a text in quotes; nothing if there is none or the closing quote is missing.
  std::optional<PlayerWord> player() {
    if (!peek().starts_with('"')) {
      const std::string_view word = next();
      return word.empty() ? std::nullopt : std::optional(PlayerWord{std::string(word)});
    }
    const std::string_view text = rest().substr(1);
    const std::size_t end = text.find('"');
    if (end == std::string_view::npos || end == 0) return std::nullopt;
    words_ = WordReader(text.substr(end + 1));
    return PlayerWord{std::string(text.substr(0, end))};
  }

 private:
  WordReader words_;
};

struct Syntax {
  ConsoleCommandHelp help;
  Result (*read)(Arguments&);
};

ParseError playerMissing() {
  return {"name a player: its number or its name, in quotes if it contains spaces (see the command players)"};
}

template <class Command>
Result readPlain(Arguments& arguments) {
  if (arguments.empty()) return Command{};
  return ParseError{"the command takes no arguments"};
}

Result readKick(Arguments& arguments) {
  auto player = arguments.player();
  if (!player) return playerMissing();
  if (isLabel(arguments.rest(), kMaxKickReasonBytes)) {
    return KickCommand{std::move(*player), std::string(arguments.rest())};
  }
  return ParseError{"the reason must have at most " + std::to_string(kMaxKickReasonBytes) + " bytes"};
}

bool looksLikeAnAddress(std::string_view word) {
  if (word.starts_with('"')) return false;
  return word.find_first_of(":/") != std::string_view::npos ||
         (word.find('.') != std::string_view::npos && word.find_first_not_of("0123456789.") == std::string_view::npos);
}

Result readBan(Arguments& arguments) {
  BanCommand command;
  if (looksLikeAnAddress(arguments.peek())) {
    auto range = AddressRange::parse(arguments.next());
    if (auto* error = std::get_if<ParseError>(&range)) return std::move(*error);
    command.target = std::get<AddressRange>(range);
  } else {
    auto player = arguments.player();
    if (!player) return playerMissing();
    command.target = std::move(*player);
  }
  command.duration = parseDuration(arguments.peek());
  if (command.duration) arguments.next();
  auto reason = parseBanReason(arguments.rest());
  if (auto* error = std::get_if<ParseError>(&reason)) return std::move(*error);
  command.reason = std::get<std::string>(std::move(reason));
  return command;
}

Result readUnban(Arguments& arguments) {
  auto range = AddressRange::parse(arguments.next());
  if (auto* error = std::get_if<ParseError>(&range)) return std::move(*error);
  if (!arguments.empty()) return ParseError{"name one address or range (see the command bans)"};
  return UnbanCommand{std::get<AddressRange>(range)};
}

template <bool muted>
Result readMute(Arguments& arguments) {
  auto player = arguments.player();
  if (!player || !arguments.empty()) return playerMissing();
  return MuteCommand{std::move(*player), muted};
}

Result readSay(Arguments& arguments) {
  const std::string_view text = arguments.rest();
  if (isLabel(text, kMaxReasonBytes) && !visibleLabel(text).empty()) return SayCommand{std::string(text)};
  return ParseError{"the text must have 1 to " + std::to_string(kMaxReasonBytes) + " bytes that can be seen"};
}

Result readDrain(Arguments& arguments) {
  DrainCommand command;
  const bool hasLimit =
      !arguments.empty() && arguments.peek().find_first_not_of("0123456789") == std::string_view::npos;
  if (hasLimit) {
    const std::string_view word = arguments.next();
    std::int64_t seconds = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), seconds);
    if (error != std::errc() || seconds < 1 || seconds > kMaxDrain.count()) {
      return ParseError{"the limit is a number of seconds from 1 to " + std::to_string(kMaxDrain.count()) +
                        "; stop ends the server at once"};
    }
    command.limit = std::chrono::seconds(seconds);
  }
  command.next = arguments.next();
  if (arguments.empty() && (command.next.empty() || isNextServer(command.next))) return command;
  return ParseError{"name a number of seconds, then perhaps one server, such as 600 play.example.org:7777"};
}

constexpr std::array kSyntax{
    Syntax{{"status", "", "server, level, players, tick times"}, &readPlain<StatusCommand>},
    Syntax{{"players", "", "each player with number, name and address"}, &readPlain<PlayersCommand>},
    Syntax{{"kick", "PLAYER [REASON]", "removes a player, who may come back"}, &readKick},
    Syntax{
        {"ban", "PLAYER|RANGE [DURATION] [REASON]", "removes a player or all of a range, and lets none of them join"},
        &readBan},
    Syntax{{"unban", "RANGE", "ends a ban"}, &readUnban},
    Syntax{{"bans", "", "all bans"}, &readPlain<BansCommand>},
    Syntax{{"mute", "PLAYER", "shows a player to everybody by number instead of by name"}, &readMute<true>},
    Syntax{{"unmute", "PLAYER", "shows the name again"}, &readMute<false>},
    Syntax{{"say", "TEXT", "shows a text to all players for some seconds"}, &readSay},
    Syntax{{"next", "", "ends the round; the next level follows"}, &readPlain<NextCommand>},
    Syntax{{"reload", "", "reads configuration, levels and bans again, as SIGHUP does"}, &readPlain<ReloadCommand>},
    Syntax{{"drain", "[SECONDS] [HOST:PORT]", "stops after this round; players are told the other server"}, &readDrain},
    Syntax{{"stop", "", "stops the server at once"}, &readPlain<StopCommand>},
    Syntax{{"help", "", "this list"}, &readPlain<HelpCommand>}};

constexpr auto kHelp = [] {
  std::array<ConsoleCommandHelp, kSyntax.size()> help{};
  for (std::size_t i = 0; i < help.size(); ++i) help[i] = kSyntax[i].help;
  return help;
}();

}  // namespace

std::span<const ConsoleCommandHelp> consoleCommands() { return kHelp; }

std::variant<ConsoleCommand, ParseError> parseConsoleCommand(std::string_view line) {
  if (!isLabel(line, kMaxConsoleLineBytes)) {
    return ParseError{"a command is one line of at most " + std::to_string(kMaxConsoleLineBytes) +
                      " bytes of text without control characters"};
  }
  WordReader words(line);
  const std::string_view name = words.next();
  const auto* syntax =
      std::find_if(kSyntax.begin(), kSyntax.end(), [name](const Syntax& one) { return one.help.name == name; });
  if (syntax == kSyntax.end()) return ParseError{quoted(name) + " is no command: help lists all"};
  Arguments arguments(words.rest());
  return syntax->read(arguments);
}

}  // namespace platon
