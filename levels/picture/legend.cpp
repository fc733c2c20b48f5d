#include "levels/picture/legend.h"

#include <string_view>

#include "levels/picture/element_painter.h"
#include "levels/picture/mark_painter.h"

namespace platon {
namespace {

constexpr double kTextSize = 20;
constexpr double kMarkWidth = 20;
constexpr double kElementWidth = 34;
constexpr double kGap = 12;

// A row that grows to the right.
class Row {
 public:
  Row(Canvas& canvas, glm::dvec2 start, const Tints& tints) : canvas_(&canvas), start_(start), tints_(&tints) {}

  glm::dvec2 start() const { return start_; }
  glm::dvec2 markMiddle() const { return start_ + glm::dvec2(kMarkWidth / 2, 0); }

  // Ends the present entry.
  void write(std::string_view text, double markWidth = kMarkWidth) {
    start_.x += markWidth + kGap;
    canvas_->text(start_ - glm::dvec2(0, kTextSize * Typeface::kCapitalHeight / 2), kTextSize, text);
    canvas_->fill({tints_->ink(), 0.6});
    start_.x += kTextSize * canvas_->typeface().width(text) + 2.4 * kGap;
  }

 private:
  Canvas* canvas_;
  glm::dvec2 start_;
  const Tints* tints_;
};

}  // namespace

void paintLegend(Canvas& canvas, glm::dvec2 start, const Tints& tints, const std::set<ElementKind>& kinds) {
  Row row(canvas, start, tints);
  paintBall(canvas, row.markMiddle(), {0, 1}, 9, tints);
  row.write("start");
  paintGoal(canvas, row.markMiddle(), 10, tints);
  row.write("goal");
  const glm::dvec2 half(0, 11);
  paintArrow(canvas, row.markMiddle() + half, row.markMiddle() - half, {tints.ink(), 0.4}, 3);
  row.write("down, next to the start");
  for (const ElementKind kind : kinds) {
    const ElementStyle style{kind, 1, {0, 1}};
    ElementPainter(canvas, tints, 2.4).paint(row.start(), row.start() + glm::dvec2(kElementWidth, 0), style);
    row.write(wordOf(kind), kElementWidth);
  }
}

}  // namespace platon
