#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "client/menu/menu_page.h"
#include "client/scene/camera.h"
#include "client/scene/scene.h"
#include "client/ui/font.h"
#include "client/ui/medal.h"
#include "client/ui/overlay.h"
#include "platon/game/level.h"

namespace platon {

/// What the list of levels shows of a level.
struct LevelEntry {
  std::string title;
  std::string solid;                          ///< its name; levels of the same solid follow each other
  std::uint32_t players = 1;                  ///< that it needs
  std::optional<std::uint32_t> bestTicks{};   ///< nothing: no time of this player's own games
  std::optional<MedalTimes> medals{};         ///< nothing: the level has none
  bool reached = false;                       ///< this player has reached its goal alone, with a time or slowed
  std::optional<std::uint32_t> olderTicks{};  ///< best time by the last rules before the present ones that have one
};

/// The list of the levels for one player, by solid, and below them those for several. `choose` gets the index of a
/// level.
MenuPage levelsPage(std::span<const LevelEntry> levels, const std::function<void(std::size_t)>& choose);

/// Item of that page which stands for a level.
std::size_t itemOfLevel(std::span<const LevelEntry> levels, std::size_t level);
/// The level that an item of that page stands for; for a heading, the level below it. `levels` is not empty.
std::size_t levelOfItem(std::span<const LevelEntry> levels, std::size_t item);

/// Shows the whole solid of a level at the right of a menu. It turns slowly, with the ball of its player in front.
class Turntable {
 public:
  /// From this width by height on, a picture has room for the solid beside a menu.
  static constexpr double kWide = 1.2;
  /// Where the middle of the solid is then, in widths of the picture from the left.
  static constexpr double kMiddle = 0.71;

  /// Shows this scene from now on, `seconds` after the last one. The solid turns slowly to where its ball, or its
  /// start, is seen; on another stage at once.
  void show(Scene scene, double seconds);

  /// Whether there is something to see.
  bool shows() const { return scene_.stage != nullptr; }
  const Scene& scene() const { return scene_; }
  /// Sees the solid in a picture of w × h pixels. In a wide picture, the solid is in the right part of it.
  Camera camera(std::uint32_t w, std::uint32_t h) const;

 private:
  Scene scene_;
  double angle_ = 0;   // of the eye about the axis, radians
  double height_ = 0;  // of the eye, in distances from the axis
};

/// Adds what is written below the solid that turns beside a menu: the title of its level, the players that it needs,
/// and the times of its medals. `width` is that of the virtual screen, and a unit of the card is `scale`
/// of its units; what finds no room beside the menu is left out.
void addLevelCard(Overlay& overlay, const LevelEntry& level, const Font& font, float width, float scale);

}  // namespace platon
