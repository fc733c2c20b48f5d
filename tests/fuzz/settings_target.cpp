#include <algorithm>
#include <set>

#include "client/ui/controls/input_mapper.h"
#include "client/ui/controls/key_names.h"
#include "client/ui/settings.h"
#include "tests/fuzz/error_faults.h"
#include "tests/fuzz/fuzz_targets.h"

namespace platon::fuzz {
namespace {

bool namesALine(const std::string& error) {
  return error.starts_with("line ") && error.size() <= 200 && isPrintable(error);
}

std::string keysFault(const Bindings& bindings) {
  std::set<Key> taken;
  for (std::size_t i = 0; i < kControlCount; ++i) {
    const ControlKeys& keys = bindings.keysOf(static_cast<Control>(i));
    if (keys.second && !keys.first) return "a control has a second key and no first one";
    for (const std::optional<Key>& key : {keys.first, keys.second, keys.pad}) {
      if (key && !canBeBound(*key)) return "a control has a key of the menu or the program";
      if (key && !taken.insert(*key).second) return "two controls have the same key";
      if (key && isOfGamepad(*key) != (key == keys.pad)) return "a key is where a button belongs, or the reverse";
    }
  }
  return {};
}

// Whatever else is held, and with any toggles.
std::string menuFault(const Settings& settings) {
  for (const Key key : {Key::kEscape, Key::kPadStart}) {
    InputMapper mapper;
    mapper.configure(settings.bindings, settings.toggled);
    for (std::size_t i = 0; i < kKeyCount; ++i) {
      if (canBeBound(static_cast<Key>(i))) mapper.handle({static_cast<Key>(i), KeyEvent::Kind::kPress}, false);
    }
    if (mapper.handle({key, KeyEvent::Kind::kPress}, false) != Action::kOpenMenu) return "a key of the menu is lost";
  }
  return {};
}

// As SettingsFile writes them.
std::string textOf(const SettingsResult& result) {
  std::string text = result.settings.text();
  for (const std::string& line : result.unknownLines) text += line + "\n";
  return text;
}

std::string rereadFault(const SettingsResult& result) {
  const SettingsResult again = parseSettings(textOf(result));
  if (again.settings.bindings != result.settings.bindings) return "the bindings differ after writing and reading";
  if (again.unknownLines != result.unknownLines) return "an unknown line differs after writing and reading";
  if (again.errors.size() != again.unknownLines.size()) return "a setting that was written is refused";
  return textOf(again) == textOf(result) ? std::string() : "the settings differ after writing and reading";
}

}  // namespace

std::string settingsFault(Bytes bytes) {
  const SettingsResult result = parseSettings(std::string(bytes.begin(), bytes.end()));
  if (!std::all_of(result.errors.begin(), result.errors.end(), namesALine)) return "an error that is no sentence";
  if (result.errors.size() < result.unknownLines.size()) return "an unknown line is not told";
  if (std::string fault = keysFault(result.settings.bindings); !fault.empty()) return fault;
  if (std::string fault = menuFault(result.settings); !fault.empty()) return fault;
  return rereadFault(result);
}

}  // namespace platon::fuzz
