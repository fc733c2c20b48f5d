#pragma once

#include "levels/drawing/colour.h"
#include "platon/game/solid.h"

namespace platon {

/// The colours of a picture: each solid has soft tints of its own.
class Tints {
 public:
  explicit Tints(SolidKind kind);

  /// Of the page.
  Colour background() const;
  /// Of segments and text.
  Colour ink() const;
  /// A face on which so much light falls, 0 … 1. Always lighter than the ink.
  Colour face(double brightness) const;

  /// The same for all solids.
  static Colour start();
  static Colour goal();
  static Colour up();
  static Colour hazard();
  static Colour checkpoint();
  /// Of keys and doors.
  static Colour lock();
  static Colour plate();

 private:
  double hue_;  // degrees
};

}  // namespace platon
