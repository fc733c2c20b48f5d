#include "server/admin/console.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "platon/game/diagnostics.h"
#include "server/admin/enforce_bans.h"

namespace platon {
namespace {

ConsoleReply failed(ParseError error) { return {false, std::move(error.what)}; }

std::string numberOf(std::uint32_t slot) { return std::to_string(slot + 1); }

std::string described(const PlayerStatus& player) {
  return "player " + numberOf(player.slot) + " (" + player.name + ")";
}

std::string lineOf(const PlayerStatus& player) {
  const bool isLocal = player.address.isLoopback();
  return numberOf(player.slot) + "  " + (isLocal ? "this machine" : player.address.text()) + "  \"" + player.name +
         "\"" + (player.client ? ", missed inputs: " + std::to_string(player.missedInputs) : ", disconnected") +
         (player.muted ? ", muted" : "");
}

std::string lineOf(const Ban& ban, UtcTime now) {
  return ban.range.text() + (ban.until ? " until " + formatUtcTime(*ban.until) : "") +
         (ban.holds(now) ? "" : " (ended)") + (ban.reason.empty() ? "" : ": " + ban.reason);
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += (text.empty() ? "" : "\n") + line;
  return text;
}

bool isQuery(const ConsoleCommand& command) {
  return std::holds_alternative<StatusCommand>(command) || std::holds_alternative<PlayersCommand>(command) ||
         std::holds_alternative<BansCommand>(command) || std::holds_alternative<HelpCommand>(command);
}

std::string counted(std::size_t count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
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
  return ParseError{"there is no player " + platon::quoted(word.text) + ": the command players lists all"};
}

ConsoleReply Console::run(const StatusCommand&, UtcTime) const {
  const std::vector<PlayerStatus> players = match_.playerStatus();
  const auto disconnected = std::count_if(players.begin(), players.end(), [](auto& player) { return !player.client; });
  const std::string round = std::to_string(match_.round()) + ", level \"" + match_.game().level().title + "\", tick " +
                            std::to_string(match_.game().tick());
  return {true,
          joined({program_.status(), "round: " + round,
                  "players: " + std::to_string(players.size()) + ", disconnected: " + std::to_string(disconnected),
                  "bans: " + std::to_string(bans_.list().size())})};
}

ConsoleReply Console::run(const PlayersCommand&, UtcTime) const {
  std::vector<std::string> lines;
  for (const PlayerStatus& player : match_.playerStatus()) lines.push_back(lineOf(player));
  return {true, lines.empty() ? "no players" : joined(lines)};
}

ConsoleReply Console::run(const KickCommand& command, UtcTime) const {
  auto found = find(command.player);
  if (auto* error = std::get_if<ParseError>(&found)) return failed(std::move(*error));
  const auto& player = std::get<PlayerStatus>(found);
  match_.kick(player.slot, command.reason.empty()
                               ? "you were removed by the operator of the server"
                               : "you were removed by the operator of the server: " + command.reason);
  return {true, "removed " + described(player)};
}

std::variant<AddressRange, ParseError> Console::rangeOf(const PlayerWord& word) const {
  auto found = find(word);
  if (auto* error = std::get_if<ParseError>(&found)) return std::move(*error);
  const auto& player = std::get<PlayerStatus>(found);
  if (!player.address.isLoopback()) return AddressRange::householdOf(player.address);
  return ParseError{described(player) + " plays on this machine, which cannot be banned: use kick"};
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
  return {true, lines.empty() ? "no bans" : joined(lines)};
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
  lines.emplace_back("DURATION: 90s, 30m, 2h, 7d or 4w; without one, a ban has no end. quit leaves the console.");
  return {true, joined(lines)};
}

}  // namespace platon
