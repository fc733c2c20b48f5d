#include "client/ui/settings.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <optional>
#include <span>
#include <sstream>

#include "client/ui/controls/bindings.h"
#include "client/ui/setting_table.h"
#include "protocol/label.h"
#include "protocol/limits.h"

namespace platon {
namespace {

bool isReadable(std::string_view word) {
  return std::all_of(word.begin(), word.end(), [](char byte) { return byte > ' ' && byte <= '~'; });
}

using Words = std::vector<std::string>;

using KeyReaders = std::array<BindingsReader, 2>;  // by KeySet
std::string joined(std::span<const std::string> words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

// What is wrong with the line of a setting; nothing if the line names no setting.
std::optional<std::string> faultOf(const Words& words, Settings& settings, KeyReaders& readers) {
  const std::span<const std::string> values = std::span(words).subspan(1);
  for (const KeySet set : {KeySet::kFirst, KeySet::kSecond}) {
    const bool isKey = words[0] == wordOf(set) && !values.empty();
    const std::optional<Control> control = isKey ? controlNamed(values[0]) : std::nullopt;
    if (!control) continue;
    const std::string fault = readers[static_cast<std::size_t>(set)].read(*control, values.subspan(1));
    return fault.empty() ? fault : words[0] + " " + values[0] + " " + fault;
  }
  for (const Setting& setting : settingTable()) {
    if (setting.name != words[0]) continue;
    const bool valid = !values.empty() && readSetting(setting, joined(values), settings);
    return valid ? "" : words[0] + " must be " + allowedValues(setting);
  }
  return std::nullopt;
}

// A name from outside goes to the terminal only if it can be read there.
std::string unknown(const std::string& name) {
  constexpr std::size_t kMaxShown = 40;
  return name.size() <= kMaxShown && isReadable(name) ? "unknown setting '" + name + "'" : "unknown setting";
}

void parseLine(const std::string& line, const std::string& where, SettingsResult& result, KeyReaders& readers) {
  std::istringstream stream(line);
  const Words words{std::istream_iterator<std::string>(stream), std::istream_iterator<std::string>()};
  if (words.empty()) return;
  const std::optional<std::string> fault = faultOf(words, result.settings, readers);
  if (!fault) result.unknownLines.push_back(line);
  if (!fault)
    result.errors.push_back(where + unknown(words[0]));
  else if (!fault->empty())
    result.errors.push_back(where + *fault);
}

}  // namespace

bool isListUrl(std::string_view text) {
  const std::size_t scheme = text.starts_with("https://") ? 8 : text.starts_with("http://") ? 7 : text.size();
  return text.size() > scheme && text.size() <= kMaxListUrlBytes && isReadable(text);
}

bool isPlayerName(std::string_view text) { return text != kNoText && isLabel(text, kMaxNameBytes); }

void takeName(std::string_view typed, std::string& name) {
  if (!isLabel(typed, kMaxNameBytes)) return;
  const std::string visible = visibleLabel(typed);
  if (isPlayerName(visible)) name = visible;
}

std::string Settings::text() const {
  return settingLines(*this) + textOf(bindings) + textOf(secondKeys, KeySet::kSecond);
}

SettingsResult parseSettings(std::string_view text) {
  SettingsResult result;
  std::istringstream lines{std::string(text)};
  std::string line;
  KeyReaders readers{BindingsReader(), BindingsReader(KeySet::kSecond)};
  for (int number = 1; std::getline(lines, line); ++number) {
    parseLine(line, "line " + std::to_string(number) + ": ", result, readers);
  }
  result.settings.bindings = readers[0].bindings();
  result.settings.secondKeys = readers[1].bindings();
  return result;
}

}  // namespace platon
