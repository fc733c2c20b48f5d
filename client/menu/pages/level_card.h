#pragma once

#include "client/menu/pages/levels_page.h"
#include "client/ui/font.h"
#include "client/ui/overlay.h"

namespace platon {

/// Adds what is written below the solid that turns beside a menu: the title of its level, the players that it needs,
/// and the times of its medals. `width` is that of the virtual screen, and a unit of the card is `scale`
/// of its units; what finds no room beside the menu is left out.
void addLevelCard(Overlay& overlay, const LevelEntry& level, const Font& font, float width, float scale);

}  // namespace platon
