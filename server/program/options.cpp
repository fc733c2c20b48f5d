#include "server/program/options.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <optional>
#include <type_traits>
#include <utility>

#include <toml++/toml.h>

#include "platon/game/diagnostics.h"
#include "platon/game/game.h"
#include "protocol/files/text_file.h"
#include "protocol/label.h"
#include "protocol/transport/server_address.h"
#include "server/admin/console.h"
#include "server/admin/metrics.h"

namespace platon {
namespace {

// Nothing for a text that is no unit.
std::optional<unsigned> bitsOf(std::string_view unit) {
  if (unit.empty()) return 0u;
  if (unit == "K") return 10u;
  if (unit == "M") return 20u;
  if (unit == "G") return 30u;
  return std::nullopt;
}

}  // namespace

std::optional<std::uint64_t> parseByteSize(std::string_view text) {
  std::uint64_t number = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number);
  const auto bits = bitsOf({rest, static_cast<std::size_t>(end - rest)});
  if (error != std::errc{} || !bits || number == 0 || number > UINT64_MAX >> *bits) return std::nullopt;
  return number << *bits;
}

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
    ServerOption{
        .name = "record-limit",
        .placeholder = "SIZE",
        .field = &ServerOptions::recordLimit,
        .help =
            "Largest total size of the recordings in this folder, in bytes or with K, M or G; the oldest are removed",
        .mustBe = "a number of bytes, or one with K, M or G, such as 500M",
        .accepts = &isByteSize},
    ServerOption{.name = "key-file",
                 .placeholder = "FILE",
                 .field = &ServerOptions::keyFile,
                 .help = "File with the key that tells clients that this is the same server; created if missing",
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
                 .help = "File that keeps the best time of each level; created if missing",
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
                 .help = "Longest time in seconds for which SIGTERM lets the players finish their round; 0: none",
                 .needsRestart = false,
                 .most = kMaxDrain.count()},
    ServerOption{.name = "drain-to",
                 .placeholder = "HOST:PORT",
                 .field = &ServerOptions::drainTo,
                 .help = "Server at which players are told to go on when this one drains",
                 .whenEmpty = "none",
                 .needsRestart = false,
                 .mustBe = "a server's address of at most 128 bytes, such as play.example.org:7777",
                 .accepts = &isOtherServer},
    ServerOption{.name = "announce",
                 .placeholder = "FILE",
                 .field = &ServerOptions::announce,
                 .help = "File with a list of servers, to which this one adds itself, for a web server to publish; "
                         "created if missing",
                 .whenEmpty = "none",
                 .isPath = true},
    ServerOption{.name = "announce-as",
                 .placeholder = "HOST:PORT",
                 .field = &ServerOptions::announceAs,
                 .help = "Address of this server in the list, at which players reach it",
                 .whenEmpty = "none",
                 .mustBe = "a server's address of at most 128 bytes, such as play.example.org:7777",
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
  std::string text = "# Configuration of platon-server. Command-line options override it.\n";
  text += "# Files and folders are relative to this file.\n";
  for (const ServerOption& option : kOptions) {
    text += "\n" + commentOf(option) + "\n" + std::string(option.name) + " = ";
    text += printed(valueOf(option, defaults)) + "\n";
  }
  return text;
}

namespace {

constexpr std::size_t kMaxConfigBytes = 1024 * 1024;

TextPosition positionOf(const toml::source_position& at) {
  return {static_cast<int>(at.line), static_cast<int>(at.column)};
}

std::string printable(std::string_view text) {
  std::string result(text);
  std::replace_if(
      result.begin(), result.end(), [](char byte) { return byte < ' ' || byte > '~'; }, '?');
  return result;
}

/// Finds what is nested so deeply in a text of TOML that the parser would overflow the stack: it makes a table in a
/// table for each part of a key, and destroys them in a recursion. Knows of the language only where strings and
/// comments end; where the text is not of this language, the parser stops at the same place or before.
class NestingCheck {
 public:
  static constexpr int kMaxParts = 8;  ///< of a key or of the name of a table
  static constexpr int kMaxDepth = 8;  ///< arrays and tables in each other

  explicit NestingCheck(std::string_view text) : text_(text) {}

  // Adds at most one error.
  void run(Diagnostics& errors) {
    while (at_ < text_.size()) {
      const std::size_t from = at_;
      step();
      if (parts_ > kMaxParts)
        return errors.error(position(from),
                            "more than " + std::to_string(kMaxParts) + " parts are joined by dots; a key has one part");
      if (depth_ > kMaxDepth)
        return errors.error(position(from), "lists and tables are nested more than " + std::to_string(kMaxDepth) +
                                                " deep; a value is at most a list");
    }
  }

 private:
  void step() {
    const char byte = text_[at_];
    if (byte == '"' || byte == '\'') return skipString(byte);
    if (byte == '#') return skipTo("\n");
    ++at_;
    if (byte == '.') ++parts_;
    if (byte == '=' || byte == ',') parts_ = 1;
    if (byte == '\n') endLine();
    if (byte == '[' || byte == '{') open(byte);
    if (byte == ']' || byte == '}') close();
    if (byte != ' ' && byte != '\t' && byte != '\n') begins_ = false;
  }

  // A table begins with its name, whose brackets are closed in its line.
  void open(char byte) {
    name_ = name_ || (byte == '[' && begins_ && depth_ == 0);
    ++depth_;
    parts_ = 1;
  }

  void close() {
    depth_ -= depth_ > 0 ? 1 : 0;
    parts_ = 1;
  }

  void endLine() {
    if (name_) depth_ = 0;
    name_ = false;
    begins_ = true;
    parts_ = 1;
  }

  void skipTo(std::string_view end) { at_ = std::min(text_.find(end, at_), text_.size()); }

  void skipString(char quote) {
    const std::string three(3, quote);
    begins_ = false;
    if (!text_.substr(at_).starts_with(three)) return skipInLine(quote);
    for (at_ += 3; at_ < text_.size() && !text_.substr(at_).starts_with(three);) skipOne(quote);
    at_ = std::min(at_ + 3, text_.size());
    for (int more = 0; more < 2 && at_ < text_.size() && text_[at_] == quote; ++more) ++at_;  // belong to the string
  }

  void skipInLine(char quote) {
    for (++at_; at_ < text_.size() && text_[at_] != quote && text_[at_] != '\n';) skipOne(quote);
    if (at_ < text_.size() && text_[at_] == quote) ++at_;
  }

  // A character of a string. Those in double quotes have a backslash before a quote that does not end them.
  void skipOne(char quote) { at_ = std::min(at_ + (quote == '"' && text_[at_] == '\\' ? 2 : 1), text_.size()); }

  TextPosition position(std::size_t at) const {
    const std::string_view before = text_.substr(0, at);
    const auto lines = std::count(before.begin(), before.end(), '\n');
    return {static_cast<int>(lines) + 1, static_cast<int>(at - (before.rfind('\n') + 1)) + 1};
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int parts_ = 1;       // of a key, perhaps in quotes
  int depth_ = 0;       // of brackets
  bool begins_ = true;  // nothing but spaces in the line so far
  bool name_ = false;   // in the name of a table
};

std::string listOfKeys() {
  std::string list;
  for (const ServerOption& option : serverOptions()) {
    const bool last = &option == &serverOptions().back();
    list += (list.empty() ? "" : last ? " and " : ", ") + std::string(option.name);
  }
  return list;
}

/// Reads the keys of a file, one by one.
class KeyReader {
 public:
  KeyReader(const std::string& file, ServerOptions& options, Diagnostics& errors)
      : folder_(std::filesystem::path(file).parent_path()), options_(options), errors_(errors) {}

  void read(const toml::key& key, const toml::node& node) {
    const auto options = serverOptions();
    const auto option =
        std::find_if(options.begin(), options.end(), [&key](const ServerOption& one) { return one.name == key.str(); });
    if (option == options.end()) {
      return errors_.error(positionOf(key.source().begin),
                           quoted(key.str()) + " is not a key of the configuration; the keys are " + listOfKeys());
    }
    const auto value = valueOf(*option, node);
    if (!value) return;
    if (const auto error = setOption(*option, *value, options_)) fail(*option, node, error->what);
  }

 private:
  void fail(const ServerOption& option, const toml::node& node, const std::string& why) {
    errors_.error(positionOf(node.source().begin), std::string(option.name) + " " + why);
  }

  // A value of a type that the option cannot have is passed on as a number out of range, which every option refuses.
  std::optional<OptionValue> valueOf(const ServerOption& option, const toml::node& node) {
    if (const auto number = node.value_exact<std::int64_t>()) return *number;
    if (const auto text = node.value_exact<std::string>()) return pathOf(option, *text);
    const toml::array* list = option.isList() ? node.as_array() : nullptr;
    if (!list) return std::int64_t{-1};
    std::vector<std::string> texts;
    for (const toml::node& item : *list) {
      const auto text = item.value_exact<std::string>();
      if (!text) {
        fail(option, item, "must be a string in quotes");
        return std::nullopt;
      }
      texts.push_back(pathOf(option, *text));
    }
    return texts;
  }

  std::string pathOf(const ServerOption& option, const std::string& text) const {
    return option.isPath && !text.empty() ? (folder_ / text).string() : text;
  }

  std::filesystem::path folder_;
  ServerOptions& options_;
  Diagnostics& errors_;
};

std::vector<Diagnostic> parseConfig(std::string_view text, const std::string& file, ServerOptions& options) {
  Diagnostics errors;
  try {
    const toml::table table = toml::parse(text);
    KeyReader reader(file, options, errors);
    for (const auto& [key, value] : table) reader.read(key, value);
  } catch (const toml::parse_error& error) {
    errors.error(positionOf(error.source().begin), printable(error.description()));
  }
  return errors.take();
}

}  // namespace

std::vector<std::string> readConfig(std::string_view text, const std::string& file, ServerOptions& options) {
  Diagnostics errors;
  NestingCheck(text).run(errors);
  std::vector<Diagnostic> found = errors.take();
  if (found.empty()) found = parseConfig(text, file, options);
  std::vector<std::string> lines;
  for (const Diagnostic& error : found) lines.push_back(format(file, error));
  return lines;
}

std::vector<std::string> readConfigFile(const std::string& path, ServerOptions& options) {
  const auto text = readTextFile(path, kMaxConfigBytes);
  if (const auto* error = std::get_if<ParseError>(&text)) {
    return {path + ": error: " + error->what + "; name a readable file after --config"};
  }
  const auto& content = std::get<std::string>(text);
  if (content.size() > kMaxConfigBytes) {
    return {path + ": error: the file has more than " + std::to_string(kMaxConfigBytes) +
            " bytes; name a configuration file after --config"};
  }
  return readConfig(content, path, options);
}

}  // namespace platon
