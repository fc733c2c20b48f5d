#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include <stb/stb_image.h>

#include "client/gl/image.h"

namespace platon {

/// A picture of tests/client/gl/golden; empty if it cannot be read.
inline Image readPng(const std::string& file) {
  int width = 0;
  int height = 0;
  int parts = 0;
  unsigned char* const pixels = stbi_load(file.c_str(), &width, &height, &parts, 3);
  if (pixels == nullptr) return {};
  Image image{static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height), {}};
  image.pixels.assign(pixels, pixels + std::ptrdiff_t{3} * width * height);
  stbi_image_free(pixels);
  return image;
}

/// The largest mean difference of a byte in a block of pixels. `block` divides both sizes, which are equal.
inline double blockDifference(const Image& a, const Image& b, std::size_t block) {
  double largest = 0;
  for (std::size_t y = 0; y < a.height; y += block) {
    for (std::size_t x = 0; x < a.width; x += block) {
      double sum = 0;
      for (std::size_t row = y; row < y + block; ++row) {
        for (std::size_t i = 3 * (row * a.width + x); i < 3 * (row * a.width + x + block); ++i)
          sum += std::abs(int{a.pixels[i]} - int{b.pixels[i]});
      }
      largest = std::max(largest, sum / static_cast<double>(3 * block * block));
    }
  }
  return largest;
}

}  // namespace platon
