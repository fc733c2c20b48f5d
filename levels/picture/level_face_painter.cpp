#include "levels/picture/level_face_painter.h"

#include <algorithm>
#include <cstddef>

#include "levels/drawing/level_marks.h"
#include "levels/picture/element_painter.h"

namespace platon {
namespace {

// The time of a stroke grows faster than the number of its lines.
constexpr std::size_t kLinesPerStroke = 256;

}  // namespace

void paintSegments(Canvas& canvas, std::span<const LevelDrawing::Line> lines, const Tints& tints, double width) {
  ElementPainter elements(canvas, tints, width);
  std::size_t walls = 0;
  for (const LevelDrawing::Line& line : lines) {
    if (line.element) continue;
    canvas.line(line.a, line.b);
    if (++walls % kLinesPerStroke == 0) canvas.stroke({tints.ink()}, width);
  }
  canvas.stroke({tints.ink()}, width);
  for (const LevelDrawing::Line& line : lines) {
    if (line.element) elements.paint(line.a, line.b, *line.element);
  }
}

LevelFacePainter::LevelFacePainter(Canvas& canvas, const LevelDrawing& drawing, int face, const PlaneMap& map,
                                   double unitsPerPixel)
    : canvas_(&canvas), drawing_(&drawing), face_(face), map_(map), unitsPerPixel_(unitsPerPixel) {}

double LevelFacePainter::visible(double units, double pixels) const { return std::max(units, pixels * unitsPerPixel_); }

void LevelFacePainter::paintGround(const Tints& tints, double brightness) {
  const Canvas::Mapped mapped(*canvas_, map_);
  canvas_->polygon(drawing_->solid.polygon());
  canvas_->fill({tints.face(brightness)});
  canvas_->polygon(drawing_->solid.polygon());
  canvas_->stroke({tints.background()}, 1.5 * unitsPerPixel_);
  paintNumber(tints);
  const auto& down = drawing_->faces[static_cast<std::size_t>(face_)].down;
  if (down) paintArrow(*canvas_, down->tail, down->head, {tints.ink(), 0.3}, 0.03 * drawing_->solid.apothem());
}

void LevelFacePainter::paintNumber(const Tints& tints) {
  const LevelDrawing::Label& label = drawing_->faces[static_cast<std::size_t>(face_)].label;
  const glm::dvec2 half(canvas_->typeface().width(label.text) / 2, Typeface::kCapitalHeight / 2);
  canvas_->text(label.middle - label.size * half, label.size, label.text);
  canvas_->fill({tints.ink(), 0.6});
}

void LevelFacePainter::paintSegments(const Tints& tints) {
  const Canvas::Mapped mapped(*canvas_, map_);
  const auto& lines = drawing_->faces[static_cast<std::size_t>(face_)].lines;
  platon::paintSegments(*canvas_, lines, tints, visible(LevelMarks::kSegmentWidth, 1.3));
}

void LevelFacePainter::paintMarks(const Tints& tints) {
  const Canvas::Mapped mapped(*canvas_, map_);
  if (drawing_->goal.face == face_)
    paintGoal(*canvas_, drawing_->goal.place, visible(LevelMarks::kGoalRadius, 8), tints);
  if (drawing_->start.face == face_) paintStart(tints);
}

void LevelFacePainter::paintStart(const Tints& tints) {
  const LevelDrawing::Ball& ball = drawing_->start;
  const double radius = visible(LevelMarks::kBallRadius, 6);
  const glm::dvec2 tail = ball.place - 1.5 * radius * ball.up;
  const glm::dvec2 head = tail - 1.8 * radius * ball.up;
  paintArrow(*canvas_, tail, head, {tints.background()}, 0.7 * radius);
  paintArrow(*canvas_, tail, head, {Tints::start()}, 0.3 * radius);
  paintBall(*canvas_, ball.place, ball.up, radius, tints);
}

}  // namespace platon
