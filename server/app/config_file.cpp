#include "server/app/config_file.h"

#include <toml++/toml.h>

#include <filesystem>
#include <string_view>

#include "protocol/label.h"
#include "protocol/program_error.h"

namespace platon {
namespace {

constexpr std::string_view kKeys = "levels, bind, port, max-players, max-per-address, name, log-format and record";

/// A key of the file and its value. Errors are thrown as ProgramError with the position in the file.
struct Entry {
  const std::string& file;
  const toml::key& key;
  const toml::node& value;

  [[noreturn]] void refuse(const std::string& why) const { refuseAt(value.source().begin, why); }
  [[noreturn]] void refuseAt(toml::source_position at, const std::string& why) const {
    throw ProgramError(ProgramError::kUsage, file + ":" + std::to_string(at.line) + ":" + std::to_string(at.column) +
                                                 ": error: " + std::string(key.str()) + " " + why);
  }

  std::string text() const {
    if (const auto found = value.value_exact<std::string>()) return *found;
    refuse("must be a string in quotes");
  }

  std::uint32_t number(std::int64_t least, std::int64_t most) const {
    const auto found = value.value_exact<std::int64_t>();
    if (found && *found >= least && *found <= most) return static_cast<std::uint32_t>(*found);
    refuse("must be a whole number from " + std::to_string(least) + " to " + std::to_string(most));
  }
};

std::string readName(const Entry& entry) {
  std::string name = entry.text();
  if (!isLabel(name, kMaxNameBytes)) {
    entry.refuse("must be a string of at most " + std::to_string(kMaxNameBytes) + " bytes without control characters");
  }
  return name;
}

LogFormat readLogFormat(const Entry& entry) {
  const std::string text = entry.text();
  if (text != "text" && text != "json") entry.refuse("must be \"text\" or \"json\"");
  return text == "json" ? LogFormat::kJson : LogFormat::kText;
}

std::string relativeToFile(const Entry& entry, const std::string& path) {
  return (std::filesystem::path(entry.file).parent_path() / path).string();
}

std::vector<std::string> readLevels(const Entry& entry) {
  const toml::array* list = entry.value.as_array();
  if (!list) entry.refuse("must be a list of files: [\"a.level\", \"b.level\"]");
  std::vector<std::string> files;
  for (const toml::node& item : *list) {
    files.push_back(relativeToFile(entry, Entry{entry.file, entry.key, item}.text()));
  }
  return files;
}

void readEntry(const Entry& entry, ServerOptions& options) {
  const std::string_view key = entry.key.str();
  if (key == "levels")
    options.levels = readLevels(entry);
  else if (key == "bind")
    options.bind = entry.text();
  else if (key == "port")
    options.port = static_cast<std::uint16_t>(entry.number(0, UINT16_MAX));
  else if (key == "max-players")
    options.maxPlayers = entry.number(1, kMaxPlayers);
  else if (key == "max-per-address")
    options.maxPerAddress = entry.number(1, kMaxPerAddress);
  else if (key == "name")
    options.name = readName(entry);
  else if (key == "log-format")
    options.logFormat = readLogFormat(entry);
  else if (key == "record")
    options.record = entry.text().empty() ? "" : relativeToFile(entry, entry.text());
  else
    entry.refuseAt(entry.key.source().begin, "is not a key of the configuration; the keys are " + std::string(kKeys));
}

toml::table parse(const std::string& path) {
  try {
    return toml::parse_file(path);
  } catch (const toml::parse_error& error) {
    const toml::source_position at = error.source().begin;
    const bool hasPosition = at.line != 0;
    const std::string where = hasPosition ? ":" + std::to_string(at.line) + ":" + std::to_string(at.column) : "";
    throw ProgramError(ProgramError::kUsage, path + where + ": error: " + std::string(error.description()) +
                                                 (hasPosition ? "" : "; name an existing file after --config"));
  }
}

}  // namespace

void readConfigFile(const std::string& path, ServerOptions& options) {
  const toml::table table = parse(path);
  for (const auto& [key, value] : table) readEntry({path, key, value}, options);
}

}  // namespace platon
