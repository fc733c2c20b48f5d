#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "levels/picture/canvas.h"

namespace platon {

/// The pixel that a colour becomes.
inline std::uint32_t pixelOf(Colour colour) {
  const auto byte = [](float part) { return static_cast<std::uint32_t>(std::lround(part * 255)); };
  return byte(colour.r) << 16 | byte(colour.g) << 8 | byte(colour.b);
}

/// The pixels of a canvas.
class Pixels {
 public:
  explicit Pixels(const Canvas& canvas) : width_(canvas.width()), values_(canvas.pixels()) {}

  std::uint32_t at(int x, int y) const { return values_[static_cast<std::size_t>(y * width_ + x)]; }
  std::ptrdiff_t count(std::uint32_t pixel) const { return std::count(values_.begin(), values_.end(), pixel); }
  std::ptrdiff_t count(Colour colour) const { return count(pixelOf(colour)); }

  friend bool operator==(const Pixels&, const Pixels&) = default;

 private:
  int width_;
  std::vector<std::uint32_t> values_;
};

}  // namespace platon
