#pragma once

#include "client/ui/font.h"
#include "client/ui/overlay.h"
#include "client/ui/settings.h"

namespace platon {

/// The menu over the game: settings and leaving. The game continues beneath it.
class Menu {
 public:
  enum class Step { kUp, kDown, kLess, kMore };

  bool open() const { return open_; }
  void toggle() { open_ = !open_; }
  /// Whether the player has chosen to leave the game.
  bool leaving() const { return leaving_; }

  /// Selects another item, or changes the setting of the selected one. No effect while the menu is closed.
  void step(Step step, Settings& settings);
  /// Activates the selected item: changes its setting, closes the menu or leaves the game. No effect while closed.
  void choose(Settings& settings);

  /// The picture of the menu; empty while it is closed. `width` is that of the virtual screen.
  Overlay overlay(const Settings& settings, const Font& font, float width) const;

 private:
  void change(Settings& settings, int direction) const;

  int item_ = 0;
  bool open_ = false;
  bool leaving_ = false;
};

}  // namespace platon
