#include "levels/picture/level_picture.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <glm/common.hpp>

#include "levels/drawing/net.h"
#include "levels/picture/face_painter.h"
#include "levels/picture/legend.h"
#include "levels/picture/level_drawing.h"
#include "levels/picture/solid_view.h"
#include "levels/picture/tints.h"

namespace platon {
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
const Box kNetBox{{568, 178}, {kPageWidth - kMargin, 898}};

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

// In the net, each face has the tint that it has in the view that shows it.
std::vector<PlacedFace> facesOfNet(const SolidFrame& solid, const SolidView& front, const SolidView& back) {
  const Net net(solid);
  std::vector<PlacedFace> group;
  for (int face = 0; face < solid.faces(); ++face) {
    const SolidView& view = front.shows(solid, face) ? front : back;
    group.push_back({face, upright(net.faceToPlane(face)), view.brightness(solid, face)});
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
    std::vector<FacePainter> painters;
    for (const PlacedFace& face : group) {
      painters.emplace_back(canvas_, drawing_, face.face, placed(face.map, origin, scale), 1 / scale);
      painters.back().paintGround(tints_, face.brightness);
    }
    for (FacePainter& painter : painters) painter.paintSegments(tints_);
    for (FacePainter& painter : painters) painter.paintMarks(tints_);
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
  page.drawGroup(facesOfNet(solid, front, back), kNetBox);
  return page.takeCanvas();
}

}  // namespace platon
