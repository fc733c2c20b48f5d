#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace platon {

/// A picture of one byte each for red, green and blue; rows from the top.
struct Image {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::vector<std::uint8_t> pixels;

  friend bool operator==(const Image&, const Image&) = default;
};

/// Reverses the order of the rows.
void flipRows(Image& image);

/// Throws std::runtime_error if the file cannot be written.
void writePng(const Image& image, const std::string& file);

}  // namespace platon
