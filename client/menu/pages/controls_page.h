#pragma once

#include <optional>
#include <string>

#include "client/menu/menu_page.h"
#include "client/ui/controls/bindings.h"

namespace platon {

/// What the page of keys waits for, and what it tells.
struct ControlsForm {
  std::optional<Control> waiting{};  ///< the control that gets the next key
  std::string told{};                ///< about the last change
};

/// The page that chooses the keys and buttons of the controls. `bindings` and `form` outlive it.
MenuPage controlsPage(Bindings& bindings, ControlsForm& form);

}  // namespace platon
