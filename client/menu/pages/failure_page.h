#pragma once

#include <functional>
#include <optional>
#include <string>

#include "client/menu/menu_page.h"

namespace platon {

/// A page that says why something failed, with what the player can do: `other`, if there is one, try again, or go back.
MenuPage failurePage(const std::string& title, const std::string& reason, const std::function<void()>& retry,
                     const std::function<void()>& back, const std::optional<MenuItem>& other = {});

}  // namespace platon
