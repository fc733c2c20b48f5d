#include "client/menu/pages/settings_pages.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

#include "client/quality/quality.h"
#include "client/ui/controls/key_names.h"
#include "protocol/limits.h"

namespace platon {
namespace {

constexpr std::array<const char*, kQualities.size()> kQualityNames{"low", "medium", "high", "highest"};
// By SettingGroup; those that follow are not on the page of the settings.
constexpr std::array<const char*, static_cast<std::size_t>(SettingGroup::kCompanions)> kGroupNames{
    "Picture", "Sound", "Comfort", "Controls", "Game"};
constexpr double kScaleStep = 0.05;  // of the render scale

MenuItem toggleItem(const char* label, bool& flag) {
  MenuItem item{MenuItem::Kind::kToggle, label, flag ? "on" : "off", flag ? 1.0 : 0.0};
  item.step = [&flag](int) { flag = !flag; };
  return item;
}

MenuItem namedFlagItem(const char* label, bool& flag, const std::array<const char*, 2>& names) {
  MenuItem item{MenuItem::Kind::kChoice, label, names[flag ? 1 : 0]};
  item.flips = true;
  item.step = [&flag](int) { flag = !flag; };
  return item;
}

std::ptrdiff_t nearest(std::span<const NamedValue> values, double number) {
  const auto closer = [number](const NamedValue& a, const NamedValue& b) {
    return std::abs(a.value - number) < std::abs(b.value - number);
  };
  return std::min_element(values.begin(), values.end(), closer) - values.begin();
}

MenuItem choiceItem(const char* label, double& number, std::span<const NamedValue> values) {
  const std::ptrdiff_t now = nearest(values, number);
  MenuItem item{MenuItem::Kind::kChoice, label, values[static_cast<std::size_t>(now)].name};
  item.step = [&number, values](int direction) {
    const std::ptrdiff_t last = std::ssize(values) - 1;
    const std::ptrdiff_t next = std::clamp<std::ptrdiff_t>(nearest(values, number) + direction, 0, last);
    number = values[static_cast<std::size_t>(next)].value;
  };
  return item;
}

// The nearest value that is whole steps from the least.
double onStep(double number, const SettingNumber& range) {
  const double steps = std::round((number - range.min) / range.step);
  // Rounded, so that the settings file gets no digits of a rounding error.
  const double exact = std::round((range.min + steps * range.step) * 1e6) / 1e6;
  return std::clamp(exact, range.min, range.max);
}

MenuItem sliderItem(const char* label, double& number, const SettingNumber& range) {
  MenuItem item{MenuItem::Kind::kSlider, label, std::to_string(std::lround(number * range.percent)) + " %",
                (number - range.min) / (range.max - range.min)};
  item.step = [&number, range](int direction) { number = onStep(number + direction * range.step, range); };
  item.set = [&number, range](double part) { number = onStep(range.min + part * (range.max - range.min), range); };
  return item;
}

MenuItem wordsItem(const char* label, const SettingWords& setting, Settings& settings) {
  MenuItem item{MenuItem::Kind::kChoice, label, std::string(setting.words[setting.index(settings)].name)};
  item.flips = setting.words.size() == 2;
  item.step = [setting, &settings](int direction) {
    const std::size_t count = setting.words.size();
    setting.choose(settings, (setting.index(settings) + count + static_cast<std::size_t>(direction)) % count);
  };
  return item;
}

std::string nameOf(const QualityChoice& choice) {
  if (!choice.level) return "automatic";
  const std::string name = kQualityNames[static_cast<std::size_t>(*choice.level)];
  return choice.scale || choice.samples ? name + ", changed" : name;
}

MenuItem levelItem(const char* label, QualityChoice& choice) {
  MenuItem item{MenuItem::Kind::kChoice, label, nameOf(choice)};
  item.step = [&choice](int direction) {
    const int now = static_cast<int>(choice.level.value_or(QualityLevel::kHigh));
    choice.choose(static_cast<QualityLevel>(std::clamp(now + direction, 0, static_cast<int>(kQualities.size()) - 1)));
  };
  return item;
}

void setScale(QualityChoice& choice, double scale) {
  const double exact = std::round(scale / kScaleStep) * kScaleStep;
  choice.scale = std::clamp(std::round(exact * 100) / 100, Quality::kMinScale, 1.0);
}

MenuItem scaleItem(const char* label, QualityChoice& choice) {
  const double scale = choice.quality().scale;
  MenuItem item{MenuItem::Kind::kSlider, label, std::to_string(std::lround(scale * 100)) + " %",
                (scale - Quality::kMinScale) / (1 - Quality::kMinScale)};
  item.step = [&choice](int direction) { setScale(choice, choice.quality().scale + direction * kScaleStep); };
  item.set = [&choice](double part) { setScale(choice, Quality::kMinScale + part * (1 - Quality::kMinScale)); };
  return item;
}

MenuItem samplesItem(const char* label, QualityChoice& choice) {
  const int samples = choice.quality().samples;
  MenuItem item{MenuItem::Kind::kChoice, label, samples == 1 ? "off" : std::to_string(samples) + " samples"};
  item.step = [&choice](int direction) {
    const int now = choice.quality().samples;
    choice.samples = std::clamp(direction > 0 ? now * 2 : now / 2, 1, Quality::kMaxSamples);
  };
  return item;
}

MenuItem measureItem(QualityChoice& choice) {
  MenuItem item{MenuItem::Kind::kAction, "Measure and choose the quality"};
  item.choose = [&choice] { choice = {}; };
  item.about = "Draws the first pictures of the next match and chooses the best quality that is smooth.";
  return item;
}

// On while a hint is left. Turned on, it shows all of them again.
MenuItem hintsItem(const char* label, Settings& settings) {
  const bool on = settings.firstKeys || settings.untold != UntoldElements{0};
  MenuItem item{MenuItem::Kind::kToggle, label, on ? "on" : "off", on ? 1.0 : 0.0};
  item.step = [&settings, on](int) {
    settings.firstKeys = settings.firstDown = settings.firstLook = !on;
    settings.untold = on ? UntoldElements{0} : UntoldElements();
  };
  return item;
}

struct ItemMaker {
  using Items = std::vector<MenuItem>;
  const char* label;
  Settings& settings;

  Items operator()(const SettingFlag& setting) const {
    bool& flag = setting.member.in(settings);
    return {setting.names[0] ? namedFlagItem(label, flag, setting.names) : toggleItem(label, flag)};
  }
  Items operator()(const SettingNumber& setting) const {
    double& number = setting.member.in(settings);
    return {setting.choices.empty() ? sliderItem(label, number, setting) : choiceItem(label, number, setting.choices)};
  }
  Items operator()(const SettingWords& setting) const { return {wordsItem(label, setting, settings)}; }
  Items operator()(QualityPart part) const {
    switch (part) {
      case QualityPart::kLevel:
        return {levelItem(label, settings.quality)};
      case QualityPart::kScale:
        return {scaleItem(label, settings.quality)};
      case QualityPart::kSamples:
        return {samplesItem(label, settings.quality), measureItem(settings.quality)};
    }
    return {};
  }
  Items operator()(SettingMember<UntoldElements>) const { return {hintsItem(label, settings)}; }
  // A text is entered on a page of its own.
  Items operator()(const SettingText&) const { return {}; }
};

}  // namespace

std::vector<MenuItem> itemsOf(const Setting& setting, Settings& settings) {
  std::vector<MenuItem> items = std::visit(ItemMaker{setting.label, settings}, setting.value);
  for (MenuItem& item : items) {
    item.inMotion = setting.inMotion;
    if (item.about.empty()) item.about = setting.about;
  }
  return items;
}

namespace {

const char* titleOf(KeySet set) { return set == KeySet::kFirst ? "Keys and buttons" : "Keys of the second player"; }

MenuItem keysItem(KeySet set, const std::function<void(KeySet)>& showKeys) {
  MenuItem item{.name = titleOf(set), .value = "choose", .choose = [showKeys, set] { showKeys(set); }};
  item.about = set == KeySet::kFirst ? "Choose which key and which button of a gamepad does what."
                                     : "Choose the keys of who joins at this keyboard with F2.";
  return item;
}

}  // namespace

MenuPage settingsPage(Settings& settings, const SubPages& pages, bool alone) {
  MenuPage page{"Settings"};
  page.standsAside = true;
  SettingGroup group = SettingGroup::kHidden;
  for (const Setting& setting : settingTable()) {
    if (setting.group >= SettingGroup::kCompanions || (setting.onlyAlone && !alone)) continue;
    if (setting.group != group) {
      group = setting.group;
      page.items.push_back({MenuItem::Kind::kHeading, kGroupNames[static_cast<std::size_t>(group)]});
      if (group == SettingGroup::kControls) {
        for (const KeySet set : {KeySet::kFirst, KeySet::kSecond}) page.items.push_back(keysItem(set, pages.keys));
        page.items.push_back({.name = "Others on this machine", .value = "choose", .choose = pages.companions});
        page.items.back().about = "Names and balls of those who join you in the game with F2, or with RT on a gamepad.";
      }
    }
    for (MenuItem& item : itemsOf(setting, settings)) page.items.push_back(std::move(item));
  }
  return page;
}

namespace {

constexpr const char* kMenuKeys = "Menus always use the arrow keys, Enter and Esc.";

std::string quoted(Control control) { return "“" + std::string(nameOf(control)) + "”"; }

std::string allKeysOf(const Bindings& bindings, Control control) {
  const KeyHints hints(bindings);
  const std::string keys = hints.keys(control);
  const std::string pad = hints.pad(control);
  if (keys.empty() && pad.empty()) return "none";
  return keys.empty() || pad.empty() ? keys + pad : keys + ", " + pad;
}

// Whether the event answers what the page waits for: tilts of a stick also arrive as keys.
bool isAnswer(const KeyEvent& event) {
  return event.kind == KeyEvent::Kind::kPress && (!isOfGamepad(event.key) || canBeBound(event.key));
}

std::string bound(Bindings& bindings, Control control, Key key) {
  const std::optional<Control> owner = bindings.bind(control, key);
  const std::string name(shownNameOf(key));
  if (!owner) return quoted(control) + " has " + name + " now.";
  return quoted(control) + " has taken " + name + " from " + quoted(*owner) + ", which has " +
         allKeysOf(bindings, *owner) + " now.";
}

void take(const KeyEvent& event, Bindings& bindings, ControlsForm& form, KeySet set) {
  const Control control = *form.waiting;
  if (event.key == Key::kPadStart) {
    form = {};
  } else if (!isAnswer(event)) {
    return;
  } else if (event.key == Key::kEscape) {
    form = {};
  } else if (event.key == Key::kDelete || event.key == Key::kBackspace) {
    bindings.clear(control);
    form = {{}, quoted(control) + " has no key or button now."};
  } else if (!canBeBound(event.key) || (set == KeySet::kSecond && isOfGamepad(event.key))) {
    form.told = std::string(shownNameOf(event.key)) + " cannot be chosen.";
  } else {
    form = {{}, bound(bindings, control, event.key)};
  }
}

std::string noteOf(const ControlsForm& form) {
  if (!form.waiting) return form.told.empty() ? kMenuKeys : form.told;
  const std::string asks = "Press the key or button for " + quoted(*form.waiting) + ". Delete: clear. Esc: cancel.";
  return form.told.empty() ? asks : form.told + " " + asks;
}

}  // namespace

MenuPage controlsPage(Bindings& bindings, ControlsForm& form, KeySet set) {
  MenuPage page{titleOf(set), {noteOf(form)}};
  for (std::size_t i = 0; i < kControlCount; ++i) {
    const auto control = static_cast<Control>(i);
    if (!isOfSet(control, set)) continue;
    page.items.push_back({.name = std::string(nameOf(control)),
                          .value = form.waiting == control ? "…" : allKeysOf(bindings, control),
                          .choose = [control, &form] {
                            form = {control, ""};
                          }});
  }
  page.items.push_back({.name = "Reset to the defaults", .choose = [&bindings, &form, set] {
                          bindings = Bindings(set);
                          form = {{}, "All of them have their defaults."};
                        }});
  if (form.waiting) page.takeKey = [&bindings, &form, set](const KeyEvent& event) { take(event, bindings, form, set); };
  return page;
}

MenuPage companionsPage(Settings& settings, CompanionsForm& form) {
  MenuPage page{"Others on this machine",
                {"In the game, F2 lets another player join at this keyboard, and RT one with a gamepad."}};
  for (std::size_t local = 1; local < kMaxLocalPlayers; ++local) {
    TextField& field = form.names[local];
    takeName(field.text(), settings.companion(local).name);
    page.items.push_back({MenuItem::Kind::kText, "Name of player " + std::to_string(local + 1), "type it here"});
    page.items.back().field = &field;
    for (const Setting& setting : settingTable()) {
      const bool isOfPlayer =
          setting.group == SettingGroup::kCompanions && setting.name.ends_with(std::to_string(local + 1));
      if (!isOfPlayer) continue;
      for (MenuItem& item : itemsOf(setting, settings)) page.items.push_back(std::move(item));
    }
  }
  return page;
}

void SettingsPages::show(MenuPage::Place place) {
  menu_->push([this, place] {
    const SubPages pages{[this, place](KeySet set) { showControls(place, set); },
                         [this, place] { showCompanions(place); }};
    MenuPage page = settingsPage(*settings_, pages, !alone_ || alone_());
    page.place = place;
    return page;
  });
}

void SettingsPages::showCompanions(MenuPage::Place place) {
  for (std::size_t local = 1; local < kMaxLocalPlayers; ++local)
    companionsForm_.names[local].setText(settings_->companion(local).name);
  menu_->push([this, place] {
    MenuPage page = companionsPage(*settings_, companionsForm_);
    page.place = place;
    return page;
  });
}

void SettingsPages::showControls(MenuPage::Place place, KeySet set) {
  form_ = {};
  menu_->push([this, place, set] {
    MenuPage page = controlsPage(set == KeySet::kFirst ? settings_->bindings : settings_->secondKeys, form_, set);
    page.place = place;
    return page;
  });
}

}  // namespace platon
