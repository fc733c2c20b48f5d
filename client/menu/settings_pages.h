#pragma once

#include "client/menu/controls_page.h"
#include "client/menu/menu.h"
#include "client/ui/settings.h"

namespace platon {

/// The settings in the menu, and the page of keys below them.
class SettingsPages {
 public:
  /// `menu` and `settings` outlive the pages.
  SettingsPages(Menu& menu, Settings& settings) : menu_(&menu), settings_(&settings) {}

  /// Shows the settings; going back leads to the present page.
  void show(MenuPage::Place place);

 private:
  void showControls(MenuPage::Place place);

  Menu* menu_;
  Settings* settings_;
  ControlsForm form_;
};

}  // namespace platon
