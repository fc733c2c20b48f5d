#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "client/menu/menu.h"
#include "client/menu/menu_page.h"
#include "client/menu/text_field.h"
#include "client/ui/controls/bindings.h"
#include "client/ui/setting_table.h"
#include "client/ui/settings.h"
#include "protocol/limits.h"

namespace platon {

/// The items of a page for a setting that is not hidden: one that changes it in `settings`, which outlive it, and below
/// that of the last part of the quality one that has it measured. A number between two choices is shown as the nearest.
/// A level of quality that is chosen takes the place of a render scale and of samples that were.
std::vector<MenuItem> itemsOf(const Setting& setting, Settings& settings);

/// What shows the pages to which that of the settings leads.
struct SubPages {
  std::function<void(KeySet)> keys;  ///< keys and buttons
  std::function<void()> companions;  ///< others on this machine
};

/// The page that changes `settings`, which outlive it. `alone`: the game may run slower.
MenuPage settingsPage(Settings& settings, const SubPages& pages, bool alone = true);

/// The names that are entered of the companions, by local number.
struct CompanionsForm {
  std::array<TextField, kMaxLocalPlayers> names{TextField(kMaxNameBytes), TextField(kMaxNameBytes),
                                                TextField(kMaxNameBytes), TextField(kMaxNameBytes)};
};

/// The page for the names and the balls of the companions. `settings` and `form` outlive it.
MenuPage companionsPage(Settings& settings, CompanionsForm& form);

/// What the page of keys waits for, and what it tells.
struct ControlsForm {
  std::optional<Control> waiting{};  ///< the control that gets the next key
  std::string told{};                ///< about the last change
};

/// The page that chooses the keys and buttons of the controls of a set. `bindings` and `form` outlive it.
MenuPage controlsPage(Bindings& bindings, ControlsForm& form, KeySet set = KeySet::kFirst);

/// The settings in the menu, and the page of keys below them.
class SettingsPages {
 public:
  /// `menu` and `settings` outlive the pages. `alone`: whether the game may run slower; not set: it may.
  SettingsPages(Menu& menu, Settings& settings, std::function<bool()> alone = {})
      : menu_(&menu), settings_(&settings), alone_(std::move(alone)) {}

  /// Shows the settings; going back leads to the present page.
  void show(MenuPage::Place place);

 private:
  void showControls(MenuPage::Place place, KeySet set);
  void showCompanions(MenuPage::Place place);

  Menu* menu_;
  Settings* settings_;
  std::function<bool()> alone_;
  ControlsForm form_;
  CompanionsForm companionsForm_;
};

}  // namespace platon
