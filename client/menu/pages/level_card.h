#pragma once

#include "client/menu/pages/levels_page.h"
#include "client/ui/font.h"
#include "client/ui/overlay.h"

namespace platon {

/// Adds what is written below the solid that turns beside a menu: the title of its level, the players that it needs,
/// and the times of its medals. `width` is that of the virtual screen; where there is no room beside the menu, nothing
/// is added.
void addLevelCard(Overlay& overlay, const LevelEntry& level, const Font& font, float width);

}  // namespace platon
