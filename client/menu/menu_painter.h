#pragma once

#include <cstddef>
#include <optional>

#include "client/menu/menu_layout.h"
#include "client/menu/menu_page.h"
#include "client/ui/font.h"
#include "client/ui/overlay.h"

namespace platon {

/// How a page is shown.
struct MenuLook {
  std::size_t focus = 0;     ///< item
  bool aside = false;        ///< only the item with the focus is shown
  bool dimsPicture = false;  ///< behind the menu
  float scale = 1;           ///< of a unit of the layout on the virtual screen
};

/// The picture of a page that lies like this on a virtual screen of this width.
Overlay paintMenu(const MenuPage& page, const MenuLayout& layout, const MenuLook& look, const Font& font, float width);

}  // namespace platon
