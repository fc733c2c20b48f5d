#include "server/app/config_file.h"

#include <toml++/toml.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <utility>

#include "platon/game/diagnostics.h"
#include "protocol/files/text_file.h"
#include "server/app/option_table.h"

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

}  // namespace

std::vector<std::string> readConfig(std::string_view text, const std::string& file, ServerOptions& options) {
  Diagnostics errors;
  try {
    const toml::table table = toml::parse(text);
    KeyReader reader(file, options, errors);
    for (const auto& [key, value] : table) reader.read(key, value);
  } catch (const toml::parse_error& error) {
    errors.error(positionOf(error.source().begin), printable(error.description()));
  }
  std::vector<std::string> lines;
  for (const Diagnostic& error : errors.take()) lines.push_back(format(file, error));
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
