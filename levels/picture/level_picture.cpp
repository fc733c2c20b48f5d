#include "levels/picture/level_picture.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/common.hpp>

#include "levels/drawing/solid_frame.h"
#include "levels/picture/element_painter.h"
#include "levels/picture/level_drawing.h"
#include "levels/picture/level_face_painter.h"
#include "levels/picture/solid_view.h"

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

namespace {

// The layout is that of a page of 1600 × 1000.
constexpr double kPageWidth = 1600;

struct Box {
  glm::dvec2 low{std::numeric_limits<double>::max()};
  glm::dvec2 high{std::numeric_limits<double>::lowest()};

  glm::dvec2 size() const { return high - low; }
  glm::dvec2 middle() const { return (low + high) / 2.0; }
};

constexpr double kMargin = 64;
const Box kFrontBox{{kMargin, 178}, {504, 524}};
const Box kBackBox{{kMargin, 552}, {504, 898}};
const Box kUnfoldingBox{{568, 178}, {kPageWidth - kMargin, 898}};

// A face of a group of faces that are drawn together.
struct PlacedFace {
  int face = 0;
  PlaneMap map;
  double brightness = 0;
};

Box boundsOf(const SolidFrame& solid, const std::vector<PlacedFace>& group) {
  Box box;
  for (const PlacedFace& face : group) {
    for (const glm::dvec2 corner : solid.polygon()) {
      box.low = glm::min(box.low, face.map(corner));
      box.high = glm::max(box.high, face.map(corner));
    }
  }
  return box;
}

std::vector<PlacedFace> facesOf(const SolidFrame& solid, const SolidView& view) {
  std::vector<PlacedFace> group;
  for (int face = 0; face < solid.faces(); ++face) {
    if (view.shows(solid, face)) group.push_back({face, view.faceMap(solid, face), view.brightness(solid, face)});
  }
  return group;
}

// In the unfolding, each face has the tint that it has in the view that shows it.
std::vector<PlacedFace> facesOfUnfolding(const SolidFrame& solid, const SolidView& front, const SolidView& back) {
  const Unfolding unfolding(solid);
  std::vector<PlacedFace> group;
  for (int face = 0; face < solid.faces(); ++face) {
    const SolidView& view = front.shows(solid, face) ? front : back;
    group.push_back({face, upright(unfolding.faceToPlane(face)), view.brightness(solid, face)});
  }
  return group;
}

// "Hexahedron".
std::string nameOfSolid(SolidKind kind) {
  std::string name(nameOf(kind));
  std::transform(name.begin() + 1, name.end(), name.begin() + 1, [](char letter) { return letter - 'A' + 'a'; });
  return name;
}

// The page, on which the parts of the picture are drawn.
class Page {
 public:
  Page(const Level& level, int width)
      : drawing_(level),
        tints_(level.solid),
        scale_(width / kPageWidth),
        canvas_(width, width * 5 / 8, tints_.background()) {}

  void drawGroup(const std::vector<PlacedFace>& group, const Box& room) {
    const Box bounds = boundsOf(drawing_.solid, group);
    const glm::dvec2 fitting = room.size() / bounds.size();
    const double scale = scale_ * std::min(fitting.x, fitting.y);
    const glm::dvec2 origin = scale_ * room.middle() - scale * bounds.middle();
    std::vector<LevelFacePainter> pictures;
    for (const PlacedFace& face : group) {
      pictures.emplace_back(canvas_, drawing_, face.face, placed(face.map, origin, scale), 1 / scale);
      pictures.back().paintGround(tints_, face.brightness);
    }
    for (LevelFacePainter& picture : pictures) picture.paintSegments(tints_);
    for (LevelFacePainter& picture : pictures) picture.paintMarks(tints_);
  }

  void drawTexts(const Level& level) {
    const Canvas::Mapped mapped(canvas_, {{scale_, 0}, {0, -scale_}, {0, 0}});
    const std::string solid = nameOfSolid(level.solid);
    const std::string before = level.title.empty() ? "" : solid + (level.author.empty() ? "" : " · ");
    drawText({kMargin, -92}, 52, 1, level.title.empty() ? solid : level.title);
    drawText({kMargin, -130}, 24, 0.6, before + level.author);
    paintLegend(canvas_, {kMargin, -946}, tints_, drawing_.kinds());
  }

  const LevelDrawing& drawing() const { return drawing_; }
  Canvas takeCanvas() { return std::move(canvas_); }

 private:
  // Smaller where the page is too narrow.
  void drawText(glm::dvec2 start, double size, double opacity, const std::string& text) {
    const double width = canvas_.typeface().width(text);
    canvas_.text(start, std::min(size, (kPageWidth - 2 * kMargin) / std::max(width, 1.0)), text);
    canvas_.fill({tints_.ink(), opacity});
  }

  LevelDrawing drawing_;
  Tints tints_;
  double scale_;
  Canvas canvas_;
};

}  // namespace

Canvas drawLevel(const Level& level, int width) {
  Page page(level, width);
  const SolidFrame& solid = page.drawing().solid;
  const SolidView front = frontView(solid, page.drawing().start.face, level.startAngle);
  const SolidView back = oppositeOf(front);
  page.drawTexts(level);
  page.drawGroup(facesOf(solid, front), kFrontBox);
  page.drawGroup(facesOf(solid, back), kBackBox);
  page.drawGroup(facesOfUnfolding(solid, front, back), kUnfoldingBox);
  return page.takeCanvas();
}

}  // namespace platon
