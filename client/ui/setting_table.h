#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "client/ui/settings.h"

namespace platon {

/// Where a value is in the settings.
template <class Value>
struct SettingMember {
  Value& (*in)(Settings& settings);
  const Value& (*of)(const Settings& settings);
};

/// `on` or `off`. A menu shows a toggle, or a choice of `names` if it has them: of off, of on.
struct SettingFlag {
  SettingMember<bool> member;
  std::array<const char*, 2> names{};
};

/// A value of a choice, and what it is called.
struct NamedValue {
  double value;
  const char* name;
};

/// A number from `min` to `max`. A menu shows a slider with steps, or a choice of `choices` if it has them.
struct SettingNumber {
  SettingMember<double> member;
  double min;
  double max;
  double step = 0;                           ///< of the slider
  double percent = 100;                      ///< that the slider shows for 1
  std::span<const NamedValue> choices = {};  ///< in ascending order
};

/// A word of the settings file, and what a menu calls it.
struct SettingWord {
  std::string_view word;
  std::string_view name;
};

/// One of `words`, given by its index. A menu goes round through all of them.
struct SettingWords {
  std::size_t (*index)(const Settings& settings);
  void (*choose)(Settings& settings, std::size_t index);
  std::span<const SettingWord> words;
  std::string_view lastComma = " or ";  ///< before the last word in a sentence that lists them
};

/// The word of the settings file for an empty text.
inline constexpr std::string_view kNoText = "none";

/// A text, which a page of the menu asks for, but not that of the settings. In the file, "none" stands for an empty
/// one, and spaces in a row for one.
struct SettingText {
  SettingMember<std::string> member;
  bool (*isValid)(std::string_view text);  ///< of a text that is not empty
  const char* form;                        ///< what is valid, as it follows "none, or"
};

/// The parts of the menu, in their order. The menu does not show settings of kHidden.
enum class SettingGroup : std::uint8_t { kPicture, kSound, kComfort, kControls, kGame, kCompanions, kHidden };

/// A setting: a row of the table that the settings file, the menu and the sentence about a wrong value follow.
struct Setting {
  std::string_view name;  ///< in the settings file
  std::size_t line;       ///< its place in the settings file, from 0: each row has another
  std::variant<SettingFlag, SettingNumber, SettingWords, QualityPart, SettingMember<UntoldElements>, SettingText> value;
  SettingGroup group;
  const char* label = "";  ///< of the menu item; of kHidden: none
  const char* about = "";  ///< what it does, as MenuItem::about
  bool inMotion = false;   ///< as MenuItem::inMotion
  bool onlyAlone = false;  ///< the menu shows it only to who is alone on the own machine
};

/// All settings but the keys of the controls, in the order of the menu.
std::span<const Setting> settingTable();

/// What a value of the file must be, as it follows "must be".
std::string allowedValues(const Setting& setting);

/// Stores a valid value of the file and returns true; otherwise it changes nothing and returns false.
bool readSetting(const Setting& setting, std::string_view value, Settings& settings);

/// The lines `name value` of the file, in its order. A part of the quality that is not set has none.
std::string settingLines(const Settings& settings);

}  // namespace platon
