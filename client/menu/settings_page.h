#pragma once

#include "client/menu/menu_page.h"
#include "client/ui/settings.h"

namespace platon {

/// The page that changes `settings`, which outlive it.
MenuPage settingsPage(Settings& settings);

}  // namespace platon
