#include "levels/picture/element_painter.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

namespace platon {
namespace {

double hueOf(SolidKind kind) {
  switch (kind) {
    case SolidKind::kTetrahedron:
      return 65;
    case SolidKind::kHexahedron:
      return 22;
    case SolidKind::kOctahedron:
      return 170;
    case SolidKind::kDodecahedron:
      return 300;
    default:
      return 235;
  }
}

}  // namespace

Tints::Tints(SolidKind kind) : hue_(hueOf(kind)) {}

Colour Tints::background() const { return oklch(0.978, 0.008, hue_ + 30); }

Colour Tints::ink() const { return oklch(0.34, 0.06, hue_ - 20); }

// Towards the light, the hue turns warmer.
Colour Tints::face(double brightness) const {
  return oklch(0.72 + 0.21 * brightness, 0.10 - 0.05 * brightness, hue_ - 30 + 45 * brightness);
}

Colour Tints::start() { return oklch(0.66, 0.19, 38); }

Colour Tints::goal() { return oklch(0.55, 0.12, 165); }

Colour Tints::up() { return oklch(0.45, 0.13, 255); }

Colour Tints::hazard() { return oklch(0.50, 0.20, 25); }

Colour Tints::checkpoint() { return oklch(0.48, 0.12, 235); }

Colour Tints::lock() { return oklch(0.52, 0.11, 80); }

Colour Tints::timed() { return oklch(0.46, 0.10, 200); }

Colour Tints::plate() { return oklch(0.48, 0.15, 310); }

namespace {

// The light ground of a mark, which parts it from segments behind it, in radii of the mark.
constexpr double kHalo = 1.2;

}  // namespace

void paintArrow(Canvas& canvas, glm::dvec2 tail, glm::dvec2 head, const Ink& ink, double width) {
  const glm::dvec2 back = 0.4 * (tail - head);
  const glm::dvec2 aside = 0.7 * glm::dvec2(-back.y, back.x);
  canvas.line(tail, head);
  const glm::dvec2 barbs[] = {head + back + aside, head, head + back - aside};
  canvas.lines(barbs);
  canvas.stroke(ink, width);
}

void paintBall(Canvas& canvas, glm::dvec2 place, glm::dvec2 up, double radius, const Tints& tints) {
  canvas.circle(place, kHalo * radius);
  canvas.fill({tints.background()});
  canvas.circle(place, radius);
  canvas.fill({Tints::start()});
  canvas.line(place, place + 0.6 * radius * up);
  canvas.stroke({tints.background()}, 0.25 * radius);
}

void paintGoal(Canvas& canvas, glm::dvec2 place, double radius, const Tints& tints) {
  const double width = 0.25 * radius;
  canvas.circle(place, kHalo * radius);
  canvas.fill({tints.background()});
  canvas.circle(place, radius - width / 2);
  canvas.stroke({Tints::goal()}, width);
  canvas.circle(place, 0.3 * radius);
  canvas.fill({Tints::goal()});
}

template <typename Draw>
void ElementPainter::repeat(const Track& track, double gap, Draw draw) const {
  const int count = std::max(1, static_cast<int>(track.length / gap));
  for (int i = 0; i < count; ++i) draw(track.length * (i + 0.5) / count);
}

void ElementPainter::paint(glm::dvec2 a, glm::dvec2 b, const ElementStyle& style) {
  Track track{a, b};
  track.length = glm::distance(a, b);
  if (track.length > 0) track.along = (b - a) / track.length;
  track.left = {-track.along.y, track.along.x};
  switch (style.kind) {
    case ElementKind::kOneway:
      return paintOneWay(track);
    case ElementKind::kUp:
      return paintUp(track, style.towards);
    case ElementKind::kHazard:
      return paintHazard(track);
    case ElementKind::kCheckpoint:
      return paintCheckpoint(track);
    case ElementKind::kKey:
      return paintKey(track, style.number);
    case ElementKind::kDoor:
      return paintDoor(track, style.number);
    case ElementKind::kPlate:
      return paintPlate(track, style.number);
    case ElementKind::kTimed:
      return paintTimed(track);
  }
}

void ElementPainter::paintOneWay(const Track& track) {
  repeat(track, 6 * width_, [&](double distance) {
    const glm::dvec2 corners[] = {track.at(distance - 1.5 * width_, -3.3 * width_), track.at(distance, -1.9 * width_),
                                  track.at(distance + 1.5 * width_, -3.3 * width_)};
    canvas_->lines(corners);
  });
  canvas_->stroke({tints_->ink(), 0.8}, 0.7 * width_);
  canvas_->line(track.a, track.b);
  canvas_->stroke({tints_->ink()}, 0.7 * width_);
}

void ElementPainter::paintUp(const Track& track, glm::dvec2 towards) {
  canvas_->line(track.a, track.b);
  canvas_->strokeDashed({tints_->ink()}, width_, 4 * width_);
  repeat(track, 12 * width_, [&](double distance) {
    const glm::dvec2 place = track.at(distance, 0);
    paintArrow(*canvas_, place - 3.0 * width_ * towards, place + 4.0 * width_ * towards, {Tints::up()}, 0.8 * width_);
  });
}

void ElementPainter::paintHazard(const Track& track) {
  std::vector<glm::dvec2> points = {track.a};
  double side = 1.6 * width_;
  repeat(track, 2 * width_, [&](double distance) {
    points.push_back(track.at(distance, side));
    side = -side;
  });
  points.push_back(track.b);
  canvas_->lines(points);
  canvas_->stroke({Tints::hazard()}, 0.8 * width_);
}

// The flag stands upright in the frame of the face.
void ElementPainter::paintCheckpoint(const Track& track) {
  canvas_->line(track.a, track.b);
  canvas_->strokeDashed({Tints::checkpoint()}, width_, 1.5 * width_);
  const glm::dvec2 foot = track.middle();
  const glm::dvec2 flag[] = {foot + width_ * glm::dvec2(0, 8), foot + width_ * glm::dvec2(5, 6.2),
                             foot + width_ * glm::dvec2(0, 4.4)};
  canvas_->polygon(flag);
  canvas_->fill({Tints::checkpoint()});
  canvas_->line(foot, flag[0]);
  canvas_->stroke({Tints::checkpoint()}, 0.7 * width_);
}

void ElementPainter::paintKey(const Track& track, int number) {
  canvas_->line(track.a, track.b);
  canvas_->strokeDashed({Tints::lock()}, width_, 0.1 * width_);
  const glm::dvec2 bow = track.middle() - glm::dvec2(5 * width_, 0);
  strokeKey(bow, {tints_->background()}, 2.2 * width_);
  strokeKey(bow, {Tints::lock()}, 0.9 * width_);
  paintNumber(bow + width_ * glm::dvec2(9.5, 0), number, Tints::lock());
}

void ElementPainter::strokeKey(glm::dvec2 bow, const Ink& ink, double thickness) {
  const auto at = [&](double x, double y) { return bow + width_ * glm::dvec2(x, y); };
  canvas_->circle(bow, 1.5 * width_);
  canvas_->line(at(1.5, 0), at(5, 0));
  canvas_->line(at(5, 0), at(5, -1.5));
  canvas_->line(at(3.6, 0), at(3.6, -1.2));
  canvas_->stroke(ink, thickness);
}

void ElementPainter::paintDoor(const Track& track, int number) {
  for (const double side : {-width_, width_}) canvas_->line(track.at(0, side), track.at(track.length, side));
  canvas_->stroke({Tints::lock()}, 0.8 * width_);
  paintNumber(track.middle(), number, Tints::lock());
}

void ElementPainter::paintPlate(const Track& track, int number) {
  canvas_->line(track.a, track.b);
  canvas_->stroke({tints_->ink()}, 0.7 * width_);
  canvas_->line(track.at(0.15 * track.length, 1.4 * width_), track.at(0.85 * track.length, 1.4 * width_));
  canvas_->stroke({Tints::plate()}, 2 * width_);
  paintNumber(track.middle() + 5.5 * width_ * track.left, number, Tints::plate());
}

// The clock stands upright in the frame of the face.
void ElementPainter::paintTimed(const Track& track) {
  repeat(track, 3 * width_,
         [&](double distance) { canvas_->line(track.at(distance, -1.2 * width_), track.at(distance, 1.2 * width_)); });
  canvas_->stroke({Tints::timed()}, 1.2 * width_);
  const glm::dvec2 middle = track.middle();
  canvas_->circle(middle, 4 * width_);
  canvas_->fill({tints_->background()});
  canvas_->circle(middle, 3.2 * width_);
  const glm::dvec2 hands[] = {middle + width_ * glm::dvec2(0, 2.2), middle, middle + width_ * glm::dvec2(1.6, 0)};
  canvas_->lines(hands);
  canvas_->stroke({Tints::timed()}, 0.7 * width_);
}

void ElementPainter::paintNumber(glm::dvec2 middle, int number, Colour colour) {
  const std::string text = std::to_string(number);
  const double radius = 3.6 * width_;
  const double size = std::min(6.5 * width_, 1.7 * radius / canvas_->typeface().width(text));
  const glm::dvec2 half(canvas_->typeface().width(text) / 2, Typeface::kCapitalHeight / 2);
  canvas_->circle(middle, radius);
  canvas_->fill({tints_->background()});
  canvas_->text(middle - size * half, size, text);
  canvas_->fill({colour});
}

}  // namespace platon
