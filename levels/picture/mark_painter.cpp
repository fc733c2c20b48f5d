#include "levels/picture/mark_painter.h"

namespace platon {
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

}  // namespace platon
