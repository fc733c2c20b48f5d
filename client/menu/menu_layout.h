#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "client/menu/menu_page.h"
#include "client/ui/font.h"
#include "client/ui/overlay.h"

namespace platon {

/// A rectangle, +y down.
struct MenuBox {
  glm::vec2 low{0};
  glm::vec2 high{0};

  bool contains(glm::vec2 place) const;
  float width() const { return high.x - low.x; }
  float height() const { return high.y - low.y; }
  bool empty() const { return low == high; }
};

/// A line of text and the box that it fits into.
struct MenuLine {
  MenuBox box;
  std::string text;
  float size = 0;
};

/// Where an item is.
struct MenuRow {
  std::size_t item = 0;  ///< index into MenuPage::items
  MenuBox box;
  MenuLine name;
  MenuLine value;     ///< of a kText: its text
  MenuBox control{};  ///< of a kChoice with its arrows, of a kToggle or kText; of a kSlider its track; else empty
  float caret = 0;    ///< of a kText: place of the caret in x
};

/// Where the parts of a page are on a screen. No two boxes of text overlap, and none is outside the screen.
struct MenuLayout {
  MenuBox panel;
  MenuLine title;
  MenuLine back{};  ///< the mark that goes back; its box is empty if there is none
  std::vector<MenuLine> notes;
  std::vector<MenuRow> rows;  ///< the visible ones, in order
  std::size_t first = 0;      ///< item of the first row
  MenuBox about{};            ///< for MenuItem::about of the item with the focus; empty if no item has one
  MenuBox scrollTrack{};      ///< empty if all items are visible
  MenuBox scrollThumb{};
};

/// Where the rows begin, and which must be among them.
struct MenuScroll {
  std::size_t first = 0;             ///< item of the first row, as far as the screen lets it be
  std::optional<std::size_t> focus;  ///< item that must be visible
};

/// Where the column of a page at the left ends.
float endOfLeftColumn(glm::vec2 screen);

/// Lays out a page on a screen of this size. Text that is too long is cut and ends with an ellipsis.
MenuLayout layOut(const MenuPage& page, const Font& font, glm::vec2 screen, const MenuScroll& scroll);

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
