#include "client/menu/pages/settings_pages.h"

#include "client/menu/pages/settings_page.h"

namespace platon {

void SettingsPages::show(MenuPage::Place place) {
  menu_->push([this, place] {
    MenuPage page = settingsPage(
        *settings_, [this, place] { showControls(place); }, !alone_ || alone_());
    page.place = place;
    return page;
  });
}

void SettingsPages::showControls(MenuPage::Place place) {
  form_ = {};
  menu_->push([this, place] {
    MenuPage page = controlsPage(settings_->bindings, form_);
    page.place = place;
    return page;
  });
}

}  // namespace platon
