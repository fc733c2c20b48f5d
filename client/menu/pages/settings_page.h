#pragma once

#include <functional>

#include "client/menu/menu_page.h"
#include "client/ui/settings.h"

namespace platon {

/// The page that changes `settings`, which outlive it. `showKeys` shows the page of keys and buttons. `alone`: the
/// game may run slower.
MenuPage settingsPage(Settings& settings, const std::function<void()>& showKeys, bool alone = true);

}  // namespace platon
