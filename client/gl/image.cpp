#include "client/gl/image.h"

#include <algorithm>
#include <cstddef>
#include <stdexcept>

#include <stb/stb_image_write.h>

#include "protocol/files/text_file.h"

namespace platon {

void flipRows(Image& image) {
  const std::ptrdiff_t row = std::ptrdiff_t{3} * image.width;
  const auto pixels = image.pixels.begin();
  for (std::ptrdiff_t top = 0, bottom = std::ptrdiff_t{image.height} - 1; top < bottom; ++top, --bottom) {
    std::swap_ranges(pixels + top * row, pixels + (top + 1) * row, pixels + bottom * row);
  }
}

void writePng(const Image& image, const std::string& file) {
  const int width = static_cast<int>(image.width);
  const int height = static_cast<int>(image.height);
  std::string png;
  const auto append = [](void* to, void* bytes, int count) {
    static_cast<std::string*>(to)->append(static_cast<const char*>(bytes), static_cast<std::size_t>(count));
  };
  const bool made = stbi_write_png_to_func(append, &png, width, height, 3, image.pixels.data(), 3 * width) != 0;
  const std::string fault = made ? replaceOutputFile(file, png) : "out of memory";
  if (!fault.empty()) throw std::runtime_error("cannot write the picture " + file + ": " + fault);
}

}  // namespace platon
