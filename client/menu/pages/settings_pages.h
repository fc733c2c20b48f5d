#pragma once

#include <functional>
#include <utility>

#include "client/menu/menu.h"
#include "client/menu/pages/controls_page.h"
#include "client/ui/settings.h"

namespace platon {

/// The settings in the menu, and the page of keys below them.
class SettingsPages {
 public:
  /// `menu` and `settings` outlive the pages. `alone`: whether the game may run slower; not set: it may.
  SettingsPages(Menu& menu, Settings& settings, std::function<bool()> alone = {})
      : menu_(&menu), settings_(&settings), alone_(std::move(alone)) {}

  /// Shows the settings; going back leads to the present page.
  void show(MenuPage::Place place);

 private:
  void showControls(MenuPage::Place place);

  Menu* menu_;
  Settings* settings_;
  std::function<bool()> alone_;
  ControlsForm form_;
};

}  // namespace platon
