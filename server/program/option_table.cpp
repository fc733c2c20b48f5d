#include "server/program/option_table.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <type_traits>
#include <utility>

#include "platon/game/game.h"
#include "protocol/label.h"
#include "protocol/transport/server_address.h"
#include "server/admin/console_command.h"
#include "server/admin/metrics_server.h"
#include "server/program/byte_size.h"

namespace platon {
namespace {

using Texts = std::vector<std::string>;

constexpr std::int64_t kMaxPerAddress = 4000;

bool isAddress(const std::string& text) { return IpAddress::parse(text).has_value(); }
bool isName(const std::string& text) { return isLabel(text, kMaxNameBytes); }
bool isSwitch(const std::string& text) { return text == "on" || text == "off"; }
bool isFormat(const std::string& text) { return text == "text" || text == "json"; }
bool isByteSize(const std::string& text) { return parseByteSize(text).has_value(); }
bool isSocketAddress(const std::string& text) { return parseSocketAddress(text).has_value(); }

bool isOtherServer(const std::string& text) { return isNextServer(text); }

const std::array kOptions{
    ServerOption{.name = kLevelsOption,
                 .placeholder = "LEVEL",
                 .field = &ServerOptions::levels,
                 .help = "Level files, played in this order",
                 .whenEmpty = "the levels of the game",
                 .isPath = true,
                 .needsRestart = false},
    ServerOption{.name = "bind",
                 .placeholder = "ADDR",
                 .field = &ServerOptions::bind,
                 .help = "Address to listen on; \"::\": all addresses of this machine",
                 .mustBe = "an IP address of this machine, such as 127.0.0.1 or ::, without a zone such as %eth0",
                 .accepts = &isAddress},
    ServerOption{.name = "port",
                 .placeholder = "N",
                 .field = &ServerOptions::port,
                 .help = "UDP port; 0: any free port",
                 .most = UINT16_MAX},
    ServerOption{.name = "max-players",
                 .placeholder = "N",
                 .field = &ServerOptions::maxPlayers,
                 .help = "Largest number of players",
                 .least = 1,
                 .most = kMaxPlayers},
    ServerOption{.name = "max-per-address",
                 .placeholder = "N",
                 .field = &ServerOptions::maxPerAddress,
                 .help = "Largest number of players from one address; loopback is not limited",
                 .least = 1,
                 .most = kMaxPerAddress},
    ServerOption{.name = "name",
                 .placeholder = "TEXT",
                 .field = &ServerOptions::name,
                 .help = "Name of the server",
                 .whenEmpty = "no name",
                 .needsRestart = false,
                 .mustBe = "a text of at most 32 bytes without control characters",
                 .accepts = &isName},
    ServerOption{.name = "chat",
                 .placeholder = "on|off",
                 .field = &ServerOptions::chat,
                 .help = "Whether players can talk to each other: \"on\" or \"off\"",
                 .mustBe = "\"on\" or \"off\"",
                 .accepts = &isSwitch},
    ServerOption{.name = "log-format",
                 .placeholder = "text|json",
                 .field = &ServerOptions::logFormat,
                 .help = "Format of the log: \"text\" or \"json\"",
                 .needsRestart = false,
                 .mustBe = "\"text\" or \"json\"",
                 .accepts = &isFormat},
    ServerOption{.name = "record",
                 .placeholder = "DIR",
                 .field = &ServerOptions::record,
                 .help = "Folder for a recording of each round, created if missing",
                 .whenEmpty = "no recordings",
                 .isPath = true},
    ServerOption{.name = "record-limit",
                 .placeholder = "SIZE",
                 .field = &ServerOptions::recordLimit,
                 .help = "Size of all recordings in this folder, in bytes or with K, M or G; the oldest are removed",
                 .mustBe = "a number of bytes, or one with K, M or G, such as 500M",
                 .accepts = &isByteSize},
    ServerOption{.name = "key-file",
                 .placeholder = "FILE",
                 .field = &ServerOptions::keyFile,
                 .help = "File with the key that tells clients that this is the same server; made if missing",
                 .whenEmpty = "server.key in $STATE_DIRECTORY, or else in the data folder of the user",
                 .isPath = true},
    ServerOption{.name = "password-file",
                 .placeholder = "FILE",
                 .field = &ServerOptions::passwordFile,
                 .help = "File with the password of the server in its first line",
                 .whenEmpty = "no password",
                 .isPath = true},
    ServerOption{.name = "ban-file",
                 .placeholder = "FILE",
                 .field = &ServerOptions::banFile,
                 .help = "File that keeps the bans; it may be empty, but must exist",
                 .whenEmpty = "bans end with the server",
                 .isPath = true},
    ServerOption{.name = "best-times",
                 .placeholder = "FILE",
                 .field = &ServerOptions::bestTimes,
                 .help = "File that keeps the best time of each level; made if missing",
                 .whenEmpty = "best times end with the server",
                 .isPath = true},
    ServerOption{.name = "socket",
                 .placeholder = "PATH",
                 .field = &ServerOptions::socket,
                 .help = "Unix socket of the console",
                 .whenEmpty = "$XDG_RUNTIME_DIR/platon-server.sock, or else /tmp/platon-server-UID.sock",
                 .isPath = true},
    ServerOption{.name = "metrics",
                 .placeholder = "ADDR:PORT",
                 .field = &ServerOptions::metrics,
                 .help = "TCP address that answers GET /metrics for Prometheus",
                 .whenEmpty = "no metrics",
                 .mustBe = "an address and a port, such as 127.0.0.1:19777 or [::1]:19777",
                 .accepts = &isSocketAddress},
    ServerOption{.name = "drain",
                 .placeholder = "SECONDS",
                 .field = &ServerOptions::drain,
                 .help = "Longest time for which SIGTERM lets the players finish their round; 0: none",
                 .needsRestart = false,
                 .most = kMaxDrain.count()},
    ServerOption{.name = "drain-to",
                 .placeholder = "HOST:PORT",
                 .field = &ServerOptions::drainTo,
                 .help = "Server where the players of a server that drains are told to go on",
                 .whenEmpty = "none",
                 .needsRestart = false,
                 .mustBe = "an address of a server of at most 128 bytes, such as play.example.org:7777",
                 .accepts = &isOtherServer},
    ServerOption{
        .name = "announce",
        .placeholder = "FILE",
        .field = &ServerOptions::announce,
        .help = "List of servers that this one enters itself into, for a web server to publish; made if missing",
        .whenEmpty = "none",
        .isPath = true},
    ServerOption{.name = "announce-as",
                 .placeholder = "HOST:PORT",
                 .field = &ServerOptions::announceAs,
                 .help = "Address in this list, at which players reach the server",
                 .whenEmpty = "none",
                 .mustBe = "an address of a server of at most 128 bytes, such as play.example.org:7777",
                 .accepts = &isOtherServer}};
static_assert(kMaxNameBytes == 32);

std::optional<ParseError> checkText(const ServerOption& option, const std::string& text) {
  const bool mayBeEmpty = !option.whenEmpty.empty();
  const bool accepted = text.empty() ? mayBeEmpty : !option.accepts || option.accepts(text);
  if (accepted) return std::nullopt;
  return ParseError{"must be " + std::string(option.mustBe)};
}

// Stores a value of a file in a member of ServerOptions.
struct Setter {
  const ServerOption& option;
  const OptionValue& value;
  ServerOptions& options;

  std::optional<ParseError> operator()(std::string ServerOptions::*field) const {
    const auto* text = std::get_if<std::string>(&value);
    if (!text) return ParseError{"must be a string in quotes"};
    auto error = checkText(option, *text);
    if (!error) options.*field = *text;
    return error;
  }

  std::optional<ParseError> operator()(LogFormat ServerOptions::*field) const {
    const auto* text = std::get_if<std::string>(&value);
    if (!text) return ParseError{"must be a string in quotes"};
    auto error = checkText(option, *text);
    if (!error) options.*field = *text == "json" ? LogFormat::kJson : LogFormat::kText;
    return error;
  }

  std::optional<ParseError> operator()(std::vector<std::string> ServerOptions::*field) const {
    const auto* list = std::get_if<Texts>(&value);
    if (!list) return ParseError{"must be a list of files: [\"a.level\", \"b.level\"]"};
    options.*field = *list;
    return std::nullopt;
  }

  template <class Number>
  std::optional<ParseError> operator()(Number ServerOptions::*field) const {
    const auto* number = std::get_if<std::int64_t>(&value);
    if (!number || *number < option.least || *number > option.most) {
      return ParseError{"must be a whole number from " + std::to_string(option.least) + " to " +
                        std::to_string(option.most)};
    }
    options.*field = static_cast<Number>(*number);
    return std::nullopt;
  }
};

OptionValue asValue(const std::string& text) { return text; }
OptionValue asValue(LogFormat format) { return std::string(format == LogFormat::kJson ? "json" : "text"); }
OptionValue asValue(const Texts& list) { return list; }
template <class Number>
requires std::is_integral_v<Number> OptionValue asValue(Number number) { return static_cast<std::int64_t>(number); }

bool isNumber(const ServerOption& option) { return option.most != 0; }

std::string printed(const OptionValue& value) {
  if (const auto* number = std::get_if<std::int64_t>(&value)) return std::to_string(*number);
  if (const auto* text = std::get_if<std::string>(&value)) return "\"" + *text + "\"";
  return "[]";  // the only list is empty by default
}

std::string commentOf(const ServerOption& option) {
  std::string comment = "# " + std::string(option.help);
  if (isNumber(option)) comment += "; " + std::to_string(option.least) + " to " + std::to_string(option.most);
  if (!option.whenEmpty.empty()) {
    comment += option.isList() ? "; []: " : "; \"\": ";
    comment += option.whenEmpty;
  }
  return comment + ".";
}

}  // namespace

std::span<const ServerOption> serverOptions() { return kOptions; }

OptionValue valueOf(const ServerOption& option, const ServerOptions& options) {
  return std::visit([&options](auto field) { return asValue(options.*field); }, option.field);
}

std::optional<ParseError> setOption(const ServerOption& option, const OptionValue& value, ServerOptions& options) {
  return std::visit(Setter{option, value, options}, option.field);
}

std::optional<ParseError> setOption(const ServerOption& option, const std::string& text, ServerOptions& options) {
  if (!isNumber(option)) return setOption(option, OptionValue(text), options);
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool whole = error == std::errc() && end == text.data() + text.size();
  return setOption(option, whole ? OptionValue(number) : OptionValue(text), options);
}

std::string printedConfig() {
  const ServerOptions defaults;
  std::string text = "# Configuration of platon-server. Options of the command line override it.\n";
  text += "# Files and folders are relative to this file.\n";
  for (const ServerOption& option : kOptions) {
    text += "\n" + commentOf(option) + "\n" + std::string(option.name) + " = ";
    text += printed(valueOf(option, defaults)) + "\n";
  }
  return text;
}

}  // namespace platon
