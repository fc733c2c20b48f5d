#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "levels/drawing/colour.h"
#include "levels/drawing/typeface.h"

struct _cairo;
struct _cairo_surface;

namespace platon {

/// A linear map of a plane into a picture, whose y points down.
struct PlaneMap {
  glm::dvec2 x{1, 0};       ///< what one unit along x of the plane becomes
  glm::dvec2 y{0, 1};       ///< the same along y
  glm::dvec2 origin{0, 0};  ///< where the origin of the plane lies in the picture

  glm::dvec2 operator()(glm::dvec2 point) const { return origin + x * point.x + y * point.y; }
};

/// The map of a plane whose own y points up: the first two columns and the last one of `matrix`, and +y upwards.
inline PlaneMap upright(const glm::dmat4& matrix) {
  const auto seen = [](const glm::dvec4& vector) { return glm::dvec2(vector.x, -vector.y); };
  return {seen(matrix[0]), seen(matrix[1]), seen(matrix[3])};
}

/// Moves and scales `map`, a map into another picture.
inline PlaneMap placed(const PlaneMap& map, glm::dvec2 origin, double scale) {
  return {scale * map.x, scale * map.y, origin + scale * map.origin};
}

/// Colour and opacity, 0 … 1.
struct Ink {
  Colour colour{0};
  double opacity = 1;
};

/// A picture that is drawn with smooth edges. Coordinates go through the current map; at first they are pixels, from
/// the upper left corner, and +y points down. The outline of a shape is collected in a path, which `fill` and `stroke`
/// draw and discard.
class Canvas {
 public:
  /// Largest width and height, pixels.
  static constexpr int kMaxSize = 8192;

  /// Throws std::runtime_error when there is no memory.
  Canvas(int width, int height, Colour background);
  ~Canvas();
  Canvas(Canvas&&) noexcept;

  /// Draws through `map` as long as the object lives. Objects end in reverse order.
  class Mapped {
   public:
    Mapped(Canvas& canvas, const PlaneMap& map);
    ~Mapped();
    Mapped(const Mapped&) = delete;
    Mapped& operator=(const Mapped&) = delete;

   private:
    Canvas* canvas_;
  };

  // Add to the path.
  void polygon(std::span<const glm::dvec2> corners);
  void line(glm::dvec2 a, glm::dvec2 b);
  /// A chain of lines.
  void lines(std::span<const glm::dvec2> points);
  void circle(glm::dvec2 centre, double radius);
  /// A line of text from `start` on its baseline. +y of the current map points up.
  void text(glm::dvec2 start, double size, std::string_view utf8);

  // Draw the path.
  void fill(const Ink& ink);
  /// Lines have round ends and joints. `width` goes through the current map.
  void stroke(const Ink& ink, double width);
  /// The same in dashes of this length, with gaps of the same length between their ends.
  void strokeDashed(const Ink& ink, double width, double dash);

  const Typeface& typeface() const { return *typeface_; }
  int width() const { return width_; }
  int height() const { return height_; }
  /// The pixels as 0x00RRGGBB, rows from the top.
  std::vector<std::uint32_t> pixels() const;

  /// The bytes of a PNG file. Throws std::runtime_error if the picture could not be drawn.
  std::string png() const;

 private:
  struct Release {
    void operator()(_cairo* context) const;
    void operator()(_cairo_surface* surface) const;
  };

  void use(const Ink& ink);

  int width_;
  int height_;
  std::unique_ptr<_cairo_surface, Release> surface_;
  std::unique_ptr<_cairo, Release> context_;
  std::unique_ptr<Typeface> typeface_;
};

}  // namespace platon
