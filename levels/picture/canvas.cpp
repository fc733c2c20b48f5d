#include "levels/picture/canvas.h"

#include <cmath>
#include <cstring>
#include <numbers>
#include <stdexcept>

#include <cairo.h>

namespace platon {
namespace {

// Cairo has cubic Bézier curves only.
void curveTo(cairo_t* context, glm::dvec2 control, glm::dvec2 to) {
  glm::dvec2 from(0);
  cairo_get_current_point(context, &from.x, &from.y);
  const glm::dvec2 first = from + (control - from) * (2.0 / 3);
  const glm::dvec2 second = to + (control - to) * (2.0 / 3);
  cairo_curve_to(context, first.x, first.y, second.x, second.y, to.x, to.y);
}

void addGlyph(cairo_t* context, const std::vector<Typeface::OutlineStep>& outline, glm::dvec2 pen, double size) {
  for (const Typeface::OutlineStep& step : outline) {
    const glm::dvec2 to = pen + size * glm::dvec2(step.to);
    switch (step.kind) {
      case Typeface::OutlineStep::Kind::kMove:
        cairo_move_to(context, to.x, to.y);
        break;
      case Typeface::OutlineStep::Kind::kLine:
        cairo_line_to(context, to.x, to.y);
        break;
      case Typeface::OutlineStep::Kind::kCurve:
        curveTo(context, pen + size * glm::dvec2(step.control), to);
        break;
    }
  }
}

// Called by Cairo with bytes of a PNG file.
cairo_status_t append(void* bytes, const unsigned char* data, unsigned length) {
  static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

}  // namespace

void Canvas::Release::operator()(cairo_t* context) const { cairo_destroy(context); }
void Canvas::Release::operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }

Canvas::Canvas(int width, int height, Colour background)
    : width_(width),
      height_(height),
      surface_(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height)),
      context_(cairo_create(surface_.get())),
      typeface_(std::make_unique<Typeface>()) {
  if (cairo_status(context_.get()) != CAIRO_STATUS_SUCCESS)
    throw std::runtime_error("there is not enough memory for the picture");
  use({background});
  cairo_paint(context_.get());
  cairo_set_line_cap(context_.get(), CAIRO_LINE_CAP_ROUND);
  cairo_set_line_join(context_.get(), CAIRO_LINE_JOIN_ROUND);
}

Canvas::~Canvas() = default;
Canvas::Canvas(Canvas&&) noexcept = default;

Canvas::Mapped::Mapped(Canvas& canvas, const PlaneMap& map) : canvas_(&canvas) {
  cairo_save(canvas_->context_.get());
  const cairo_matrix_t matrix{map.x.x, map.x.y, map.y.x, map.y.y, map.origin.x, map.origin.y};
  cairo_transform(canvas_->context_.get(), &matrix);
}

Canvas::Mapped::~Mapped() { cairo_restore(canvas_->context_.get()); }

void Canvas::polygon(std::span<const glm::dvec2> corners) {
  lines(corners);
  cairo_close_path(context_.get());
}

void Canvas::line(glm::dvec2 a, glm::dvec2 b) {
  cairo_move_to(context_.get(), a.x, a.y);
  cairo_line_to(context_.get(), b.x, b.y);
}

void Canvas::lines(std::span<const glm::dvec2> points) {
  cairo_new_sub_path(context_.get());
  for (const glm::dvec2 point : points) cairo_line_to(context_.get(), point.x, point.y);
}

void Canvas::circle(glm::dvec2 centre, double radius) {
  cairo_new_sub_path(context_.get());
  cairo_arc(context_.get(), centre.x, centre.y, radius, 0, 2 * std::numbers::pi);
  cairo_close_path(context_.get());
}

void Canvas::text(glm::dvec2 start, double size, std::string_view utf8) {
  for (const char32_t point : codePointsOf(utf8)) {
    addGlyph(context_.get(), typeface_->outline(point), start, size);
    start.x += size * typeface_->advance(point);
  }
}

// Cairo would round each part down.
void Canvas::use(const Ink& ink) {
  const auto part = [](float value) { return std::round(double{255} * value) / 255; };
  cairo_set_source_rgba(context_.get(), part(ink.colour.r), part(ink.colour.g), part(ink.colour.b), ink.opacity);
}

void Canvas::fill(const Ink& ink) {
  use(ink);
  cairo_fill(context_.get());
}

void Canvas::stroke(const Ink& ink, double width) {
  use(ink);
  cairo_set_line_width(context_.get(), width);
  cairo_stroke(context_.get());
}

void Canvas::strokeDashed(const Ink& ink, double width, double dash) {
  // The round ends lengthen each dash by `width`.
  const double lengths[] = {dash, dash + width};
  cairo_set_dash(context_.get(), lengths, 2, 0);
  stroke(ink, width);
  cairo_set_dash(context_.get(), nullptr, 0, 0);
}

std::vector<std::uint32_t> Canvas::pixels() const {
  cairo_surface_flush(surface_.get());
  const unsigned char* row = cairo_image_surface_get_data(surface_.get());
  std::vector<std::uint32_t> pixels(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
  const auto rowBytes = static_cast<std::size_t>(width_) * sizeof(std::uint32_t);
  for (std::size_t y = 0; y < static_cast<std::size_t>(height_); ++y) {
    std::memcpy(&pixels[y * static_cast<std::size_t>(width_)], row, rowBytes);
    row += cairo_image_surface_get_stride(surface_.get());
  }
  for (std::uint32_t& pixel : pixels) pixel &= 0xFFFFFF;
  return pixels;
}

std::string Canvas::png() const {
  std::string bytes;
  cairo_status_t status = cairo_status(context_.get());
  if (status == CAIRO_STATUS_SUCCESS) status = cairo_surface_write_to_png_stream(surface_.get(), append, &bytes);
  if (status != CAIRO_STATUS_SUCCESS) throw std::runtime_error(cairo_status_to_string(status));
  return bytes;
}

}  // namespace platon
