#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <stb/stb_image.h>

#include "client/gl/gl_context.h"
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

/// The largest mean difference of a byte in a block of pixels; blocks at the right and at the bottom may be smaller.
/// The sizes are equal.
inline double blockDifference(const Image& a, const Image& b, std::size_t block) {
  double largest = 0;
  for (std::size_t y = 0; y < a.height; y += block) {
    for (std::size_t x = 0; x < a.width; x += block) {
      const std::size_t bottom = std::min<std::size_t>(y + block, a.height);
      const std::size_t right = std::min<std::size_t>(x + block, a.width);
      double sum = 0;
      for (std::size_t row = y; row < bottom; ++row) {
        for (std::size_t i = 3 * (row * a.width + x); i < 3 * (row * a.width + right); ++i)
          sum += std::abs(int{a.pixels[i]} - int{b.pixels[i]});
      }
      largest = std::max(largest, sum / static_cast<double>(3 * (bottom - y) * (right - x)));
    }
  }
  return largest;
}

/// The greatest difference of a byte; 255 if the sizes differ.
inline int largestDifference(const Image& a, const Image& b) {
  if (a.pixels.size() != b.pixels.size()) return 255;
  int largest = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i)
    largest = std::max(largest, std::abs(int{a.pixels[i]} - int{b.pixels[i]}));
  return largest;
}

/// Compares a picture with tests/client/gl/golden/NAME.png: every pixel on the driver of the golden pictures, blocks of
/// them on others. If PLATON_DRAW_GOLDEN is set, writes it there instead.
inline void expectGolden(const Image& image, const std::string& name, std::size_t block = 30) {
  // Processors of another kind round the results of this driver in another way.
  const std::string driver = "llvmpipe (LLVM 15.0.6, 256 bits)";
  constexpr int kRounding = 2;        // steps of a colour, on that driver
  constexpr double kOtherDriver = 8;  // mean steps of a colour in a block, on others
  EXPECT_EQ(takeGlErrors(), "");
  const std::filesystem::path golden = "tests/client/gl/golden/" + name + ".png";
  if (std::getenv("PLATON_DRAW_GOLDEN") != nullptr) {
    std::filesystem::create_directories(golden.parent_path());
    return writePng(image, golden.string());
  }
  const std::filesystem::path drawn = testing::TempDir() + "golden/" + name + ".png";
  std::filesystem::create_directories(drawn.parent_path());
  writePng(image, drawn.string());
  const Image expected = readPng(golden.string());
  const std::string advice = "look at " + drawn.string() + ", and if it is right, run tests/client/gl/golden/draw.sh";
  ASSERT_EQ(expected.pixels.size(), image.pixels.size()) << advice;
  EXPECT_LT(blockDifference(image, expected, block), kOtherDriver) << advice;
  const int allowed = driverName() == driver ? kRounding : 255;
  EXPECT_LE(largestDifference(image, expected), allowed) << advice;
}

}  // namespace platon
