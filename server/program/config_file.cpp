#include "server/program/config_file.h"

#include <toml++/toml.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <utility>

#include "platon/game/diagnostics.h"
#include "protocol/files/text_file.h"
#include "server/program/option_table.h"

namespace platon {
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
        return errors.error(position(from), "more than " + std::to_string(kMaxDepth) +
                                                " lists and tables are in each other; a value is at most a list");
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
    return {path + ": error: the file has more than " + std::to_string(kMaxConfigBytes) + " bytes"};
  }
  return readConfig(content, path, options);
}

}  // namespace platon
