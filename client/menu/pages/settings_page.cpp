#include "client/menu/pages/settings_page.h"

#include <array>
#include <cstddef>
#include <utility>

#include "client/menu/pages/setting_items.h"

namespace platon {
namespace {

// By SettingGroup.
constexpr std::array<const char*, static_cast<std::size_t>(SettingGroup::kHidden)> kGroupNames{
    "Picture", "Sound", "Comfort", "Controls", "Game"};

}  // namespace

MenuPage settingsPage(Settings& settings, const std::function<void()>& showKeys, bool alone) {
  MenuPage page{"Settings"};
  page.standsAside = true;
  SettingGroup group = SettingGroup::kHidden;
  for (const Setting& setting : settingTable()) {
    if (setting.group == SettingGroup::kHidden || (setting.onlyAlone && !alone)) continue;
    if (setting.group != group) {
      group = setting.group;
      page.items.push_back({MenuItem::Kind::kHeading, kGroupNames[static_cast<std::size_t>(group)]});
      if (group == SettingGroup::kControls) {
        page.items.push_back({.name = "Keys and buttons", .value = "choose", .choose = showKeys});
      }
    }
    for (MenuItem& item : itemsOf(setting, settings)) page.items.push_back(std::move(item));
  }
  return page;
}

}  // namespace platon
