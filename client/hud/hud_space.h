#pragma once

#include <vector>

#include "client/ui/font.h"
#include "client/ui/overlay.h"

namespace platon {

/// A rectangle of a virtual screen.
struct HudBox {
  glm::vec2 low{0};
  glm::vec2 high{0};

  bool overlaps(const HudBox& other) const {
    return low.x < other.high.x && other.low.x < high.x && low.y < other.high.y && other.low.y < high.y;
  }
};

/// The smallest box around panels and texts; `part` has at least one of them.
HudBox boundsOf(const Overlay& part, const Font& font);
/// The part at another place.
Overlay movedBy(Overlay part, glm::vec2 offset);

/// The places of the display: parts that are added never overlap and never leave the screen.
class HudSpace {
 public:
  HudSpace(const Font& font, glm::vec2 screen) : font_(&font), screen_(screen) {}

  /// Nothing is added in this height above the lower edge, ≥ 0, from now on.
  void reserveFoot(float height);
  /// Whether the part would be added.
  bool fits(const Overlay& part) const;
  /// Adds the part where it is, if there is room. Returns whether it was added; an empty part needs no room.
  bool add(const Overlay& part);
  /// Likewise, but others may be added over it.
  void addOver(const Overlay& part);

  glm::vec2 screen() const { return screen_; }
  /// Lowest end of what was added in the left or right half of the screen, and highest start of what was added in the
  /// lower half; 0 and the height without any.
  float endOfColumn(bool right) const;
  float startOfFoot() const;
  const Overlay& overlay() const { return overlay_; }

 private:
  void append(const Overlay& part);

  const Font* font_;
  glm::vec2 screen_;
  std::vector<HudBox> taken_;
  Overlay overlay_;
};

}  // namespace platon
