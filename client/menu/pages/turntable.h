#pragma once

#include <cstdint>
#include <memory>

#include "client/scene/camera.h"
#include "client/scene/scene.h"
#include "platon/game/level.h"

namespace platon {

/// Shows the whole solid of a level, which turns slowly, at the right of a menu.
class Turntable {
 public:
  /// From this width by height on, a picture has room for the solid beside a menu.
  static constexpr double kWide = 1.2;
  /// Where the middle of the solid is then, in widths of the picture from the left.
  static constexpr double kMiddle = 0.71;

  /// Shows this level from now on, first the face of its start if that is at a side. No effect if it does already.
  void show(const std::shared_ptr<const Level>& level);
  /// Turns the solid for `seconds`.
  void advance(double seconds);

  /// Whether there is something to see.
  bool shows() const { return scene_.stage != nullptr; }
  /// The level, without players.
  const Scene& scene() const { return scene_; }
  /// Sees the solid in a picture of w × h pixels. In a wide picture, the solid is in the right part of it.
  Camera camera(std::uint32_t w, std::uint32_t h) const;

 private:
  std::shared_ptr<const Level> level_;
  Scene scene_;
  double angle_ = 0;  // radians
};

}  // namespace platon
