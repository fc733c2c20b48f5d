#pragma once

#include "client/ui/font.h"
#include "client/ui/overlay.h"
#include "client/ui/settings.h"

namespace platon {

/// The menu over the game: comfort, controls, leaving. The game goes on beneath it.
class Menu {
 public:
  enum class Step { kUp, kDown, kLess, kMore };

  bool open() const { return open_; }
  void toggle() { open_ = !open_; }
  /// The player chose to leave the game.
  bool leaving() const { return leaving_; }

  /// Moves between the items, or changes the chosen one; without effect while closed.
  void take(Step step, Settings& settings);
  /// Acts on the chosen item: changes it, goes back to the game or leaves it.
  void choose(Settings& settings);

  /// `width` of the virtual screen.
  Overlay overlay(const Settings& settings, const Font& font, float width) const;

 private:
  void change(Settings& settings, int direction) const;

  int item_ = 0;
  bool open_ = false;
  bool leaving_ = false;
};

}  // namespace platon
