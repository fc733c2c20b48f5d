#include "server/admin/console.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>
#include <vector>

#include "platon/game/diagnostics.h"
#include "platon/game/utf8.h"
#include "protocol/files/word_reader.h"
#include "protocol/label.h"
#include "protocol/limits.h"
#include "protocol/texts.h"
#include "protocol/transport/server_address.h"
#include "server/admin/bans.h"
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
  return {"name a player by number or by name, in quotes if it contains spaces (see the command 'players')"};
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
  if (!arguments.empty()) return ParseError{"name one address or range (see the command 'bans')"};
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
  return ParseError{"the text must have at most " + std::to_string(kMaxReasonBytes) +
                    " bytes, and something that can be seen"};
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
      return ParseError{"the limit must be a number of seconds from 1 to " + std::to_string(kMaxDrain.count()) +
                        "; 'stop' stops the server at once"};
    }
    command.limit = std::chrono::seconds(seconds);
  }
  command.next = arguments.next();
  if (arguments.empty() && (command.next.empty() || isNextServer(command.next))) return command;
  return ParseError{"name a number of seconds, a server, or both in this order, such as 600 play.example.org:7777"};
}

constexpr std::array kSyntax{
    Syntax{{"status", "", "server, level, players, tick times"}, &readPlain<StatusCommand>},
    Syntax{{"players", "", "each player with number, name and address"}, &readPlain<PlayersCommand>},
    Syntax{{"kick", "PLAYER [REASON]", "removes a player, who may come back"}, &readKick},
    Syntax{
        {"ban", "PLAYER|RANGE [DURATION] [REASON]", "removes a player or all players of a range, and keeps them out"},
        &readBan},
    Syntax{{"unban", "RANGE", "ends a ban"}, &readUnban},
    Syntax{{"bans", "", "all bans"}, &readPlain<BansCommand>},
    Syntax{{"mute", "PLAYER", "shows a player to everybody by number instead of by name"}, &readMute<true>},
    Syntax{{"unmute", "PLAYER", "shows the name again"}, &readMute<false>},
    Syntax{{"say", "TEXT", "shows a text to all players for a few seconds"}, &readSay},
    Syntax{{"next", "", "ends the round; the next level follows"}, &readPlain<NextCommand>},
    Syntax{{"reload", "", "reads configuration, levels and bans again, as SIGHUP does"}, &readPlain<ReloadCommand>},
    Syntax{{"drain", "[SECONDS] [HOST:PORT]",
            "stops the server after this round, and tells the players to go on at HOST:PORT"},
           &readDrain},
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
  if (syntax == kSyntax.end()) return ParseError{quoted(name) + " is not a command: 'help' lists all commands"};
  Arguments arguments(words.rest());
  return syntax->read(arguments);
}

namespace {

// The text with '?' for what a terminal might obey, such as a control character, and for bytes that are no UTF-8.
std::string shownOnTerminal(std::string_view text) {
  std::string shown;
  while (!text.empty()) {
    const auto character = decodeUtf8(text);
    const std::string_view bytes = text.substr(0, character ? character->length : 1);
    shown += isLabel(bytes, bytes.size()) ? bytes : "?";
    text.remove_prefix(bytes.size());
  }
  return shown;
}

}  // namespace

std::string encode(const ConsoleReply& reply) {
  std::string encoded;
  for (std::string_view left = reply.text; !left.empty();) {
    const std::size_t end = std::min(left.find('\n'), left.size());
    encoded.append(" ").append(left.substr(0, end)).append("\n");
    left.remove_prefix(std::min(end + 1, left.size()));
  }
  return encoded + (reply.ok ? "ok\n" : "failed\n");
}

std::optional<ConsoleReply> ConsoleReplyReader::add(std::string_view line) {
  if (line.starts_with(' ')) {
    if (!reply_.text.empty()) reply_.text += '\n';
    reply_.text += shownOnTerminal(line.substr(1));
    return std::nullopt;
  }
  reply_.ok = line == "ok";
  return std::exchange(reply_, {});
}

namespace {

ConsoleReply failed(ParseError error) { return {false, std::move(error.what)}; }

std::string numberOf(std::uint32_t slot) { return std::to_string(slot + 1); }

std::string described(const PlayerStatus& player) {
  return "player " + numberOf(player.slot) + " (" + player.name + ")";
}

std::string lineOf(const PlayerStatus& player) {
  const bool isLocal = player.address.isLoopback();
  return numberOf(player.slot) + "  " + (isLocal ? "this machine" : player.address.text()) + "  \"" + player.name +
         "\"" + (player.companionOf ? ", with player " + numberOf(*player.companionOf) : "") +
         (player.client ? ", missed inputs: " + std::to_string(player.missedInputs) : ", disconnected") +
         (player.muted ? ", muted" : "");
}

std::string lineOf(const Ban& ban, UtcTime now) {
  return ban.range.text() + (ban.until ? " until " + formatUtcTime(*ban.until) : "") +
         (ban.holds(now) ? "" : " (ended)") + (ban.reason.empty() ? "" : ": " + ban.reason);
}

bool isQuery(const ConsoleCommand& command) {
  return std::holds_alternative<StatusCommand>(command) || std::holds_alternative<PlayersCommand>(command) ||
         std::holds_alternative<BansCommand>(command) || std::holds_alternative<HelpCommand>(command);
}

std::string usageOf(const ConsoleCommandHelp& command) {
  return std::string(command.name) + (command.arguments.empty() ? "" : " ") + std::string(command.arguments);
}

}  // namespace

ConsoleReply Console::execute(std::string_view line, UtcTime now) {
  auto parsed = parseConsoleCommand(line);
  if (auto* error = std::get_if<ParseError>(&parsed)) return failed(std::move(*error));
  const auto& command = std::get<ConsoleCommand>(parsed);
  ConsoleReply reply = std::visit([this, now](const auto& one) { return run(one, now); }, command);
  if (reply.ok && !isQuery(command)) program_.log(line);
  return reply;
}

// A number always means a slot, so that nobody can be hit by the choice of a name.
std::variant<PlayerStatus, ParseError> Console::find(const PlayerWord& word) const {
  std::vector<PlayerStatus> found = match_.playerStatus();
  const bool isNumber = word.text.find_first_not_of("0123456789") == std::string::npos;
  std::erase_if(found, [&](const PlayerStatus& player) {
    return isNumber ? numberOf(player.slot) != word.text : player.name != word.text;
  });
  if (!found.empty()) return found.front();  // no two players have one name
  return ParseError{"there is no player " + platon::quoted(word.text) + ": the command 'players' lists all of them"};
}

ConsoleReply Console::run(const StatusCommand&, UtcTime) const {
  const std::vector<PlayerStatus> players = match_.playerStatus();
  const auto disconnected = std::count_if(players.begin(), players.end(), [](auto& player) { return !player.client; });
  const std::string round = std::to_string(match_.round()) + ", level \"" + match_.game().level().title + "\", tick " +
                            std::to_string(match_.game().tick());
  return {true,
          joined({program_.status(), "round: " + round,
                  "players: " + std::to_string(players.size()) + ", disconnected: " + std::to_string(disconnected),
                  "bans: " + std::to_string(bans_.list().size())},
                 "\n")};
}

ConsoleReply Console::run(const PlayersCommand&, UtcTime) const {
  std::vector<std::string> lines;
  for (const PlayerStatus& player : match_.playerStatus()) lines.push_back(lineOf(player));
  return {true, lines.empty() ? "no players" : joined(lines, "\n")};
}

ConsoleReply Console::run(const KickCommand& command, UtcTime) const {
  auto found = find(command.player);
  if (auto* error = std::get_if<ParseError>(&found)) return failed(std::move(*error));
  const auto& player = std::get<PlayerStatus>(found);
  const std::size_t before = match_.allPlayers();
  match_.kick(player.slot, command.reason.empty()
                               ? "you were removed by the operator of the server"
                               : "you were removed by the operator of the server: " + command.reason);
  const std::size_t others = before - match_.allPlayers() - 1;
  return {true, "removed " + described(player) + (others > 0 ? ", and " + counted(others, "companion") : "")};
}

std::variant<AddressRange, ParseError> Console::rangeOf(const PlayerWord& word) const {
  auto found = find(word);
  if (auto* error = std::get_if<ParseError>(&found)) return std::move(*error);
  const auto& player = std::get<PlayerStatus>(found);
  if (!player.address.isLoopback()) return AddressRange::householdOf(player.address);
  return ParseError{described(player) + " plays on this machine, which cannot be banned: use 'kick'"};
}

ConsoleReply Console::run(const BanCommand& command, UtcTime now) const {
  std::variant<AddressRange, ParseError> range = ParseError{};
  if (const auto* word = std::get_if<PlayerWord>(&command.target))
    range = rangeOf(*word);
  else
    range = std::get<AddressRange>(command.target);
  if (auto* error = std::get_if<ParseError>(&range)) return failed(std::move(*error));
  Ban ban{std::get<AddressRange>(range), std::nullopt, command.reason};
  if (command.duration) ban.until = now + *command.duration;
  if (auto error = bans_.add(ban, now)) return failed(std::move(*error));
  return {true,
          "banned " + lineOf(ban, now) + "\nremoved " + counted(enforceBans(match_, bans_.list(), now), "player") +
              (bans_.hasFile() ? "" : "\nthe ban ends with the server: name a file after --ban-file to keep bans")};
}

ConsoleReply Console::run(const UnbanCommand& command, UtcTime now) const {
  if (auto error = bans_.remove(command.range, now)) return failed(std::move(*error));
  return {true, command.range.text() + " may join again"};
}

ConsoleReply Console::run(const BansCommand&, UtcTime now) const {
  const std::vector<Ban> bans = bans_.list().bans();
  std::vector<std::string> lines;
  for (const Ban& ban : bans) {
    if (lines.size() == kMaxBansListed) break;
    lines.push_back(lineOf(ban, now));
  }
  if (bans.size() > lines.size()) lines.push_back("and " + std::to_string(bans.size() - lines.size()) + " more");
  return {true, lines.empty() ? "no bans" : joined(lines, "\n")};
}

ConsoleReply Console::run(const MuteCommand& command, UtcTime) const {
  auto found = find(command.player);
  if (auto* error = std::get_if<ParseError>(&found)) return failed(std::move(*error));
  const auto& player = std::get<PlayerStatus>(found);
  match_.mute(player.slot, command.muted);
  const auto after = std::get<PlayerStatus>(find({numberOf(player.slot)}));
  return {true, described(player) + " is shown as \"" + after.shownName + "\""};
}

ConsoleReply Console::run(const SayCommand& command, UtcTime) const {
  match_.say(command.text);
  return {true, "said to " + counted(match_.players(), "player")};
}

ConsoleReply Console::run(const NextCommand&, UtcTime) const {
  if (match_.endRoundNow()) return {true, "the round is over"};
  return {false, "the round is over already; the next one starts within seconds"};
}

ConsoleReply Console::run(const StopCommand&, UtcTime) const {
  program_.stop();
  return {true, "the server stops"};
}

ConsoleReply Console::run(const HelpCommand&, UtcTime) const {
  std::size_t width = 0;
  for (const ConsoleCommandHelp& one : consoleCommands()) width = std::max(width, usageOf(one).size());
  std::vector<std::string> lines;
  for (const ConsoleCommandHelp& one : consoleCommands()) {
    std::string usage = usageOf(one);
    usage.resize(width, ' ');
    lines.push_back(usage + "  " + std::string(one.meaning));
  }
  lines.emplace_back(
      "PLAYER: number or name, in quotes if it contains spaces. RANGE: 192.0.2.7, 192.0.2.0/24, 2001:db8::/32.");
  lines.emplace_back("DURATION: 90s, 30m, 2h, 7d or 4w; without one, a ban has no end. 'quit' leaves the console.");
  return {true, joined(lines, "\n")};
}

}  // namespace platon
