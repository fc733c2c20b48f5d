#include "tests/exactness/oracle/trace/random_scene.h"

#include <algorithm>
#include <array>

#include "tests/exactness/oracle/sweep/random_shapes.h"

namespace platon::oracle {
namespace {

constexpr std::int64_t kEntities = 8;
constexpr auto kShapes =
    std::to_array({ShapeKind::Any, ShapeKind::ManyVertices, ShapeKind::Ball, ShapeKind::Needle, ShapeKind::Box});

Vec halfOf(Vec v) { return {v.x / 2, v.y / 2}; }

/// A chain of segments, each starting within two subunits of the end of the last one.
void addChain(Scene& scene, RandomSource& random) {
  const Vec step = random.vector(scene.scale);
  Vec at = random.vector(4 * scene.scale);
  for (std::int64_t links = random.between(2, 6); links > 0; --links) {
    const Vec next = at + step + random.vector(2);
    scene.lines.push_back(random.oneIn(2) ? Segment{at, next} : Segment{next, at});
    at = next + (random.oneIn(2) ? Vec{} : random.vector(2));
  }
}

/// Two segments that form a wedge.
void addWedge(Scene& scene, RandomSource& random) {
  const Vec tip = random.vector(4 * scene.scale);
  const Vec axis = random.vector(4 * scene.scale);
  const Vec side = random.vector(scene.scale / 4 + 2);
  scene.lines.push_back({tip, tip + axis + side});
  scene.lines.push_back({tip + random.vector(1), tip + axis - side});
}

/// Two parallel segments about as far apart as the shape is wide: it fits with room, exactly, or not at all.
void addCorridor(Scene& scene, RandomSource& random) {
  const Box box = boxOf(scene.shape);
  const Vec start = random.vector(3 * scene.scale);
  const bool upright = random.oneIn(2);
  const std::int64_t width = (upright ? box.high.x - box.low.x : box.high.y - box.low.y) + random.between(-1, 2);
  const Vec across = upright ? Vec{width, 0} : Vec{0, width};
  const Vec along = upright ? Vec{0, 4 * scene.scale} : Vec{4 * scene.scale, 0};
  scene.lines.push_back({start, start + along});
  scene.lines.push_back({start + across, start + across + along});
}

void addLines(Scene& scene, RandomSource& random) {
  for (std::int64_t i = random.between(3, 12); i > 0; --i) {
    switch (random.between(0, 5)) {
      case 0:
        addChain(scene, random);
        break;
      case 1:
        addWedge(scene, random);
        break;
      case 2:
        addCorridor(scene, random);
        break;
      case 3:
        scene.lines.push_back(randomSegment(SegmentKind::Parallel, scene.shape, 4 * scene.scale, random));
        break;
      case 4:
        scene.lines.push_back(randomSegment(SegmentKind::Point, scene.shape, 4 * scene.scale, random));
        break;
      default:
        scene.lines.push_back({random.vector(4 * scene.scale), random.vector(4 * scene.scale)});
    }
  }
  const std::int64_t wall = 5 * scene.scale;
  scene.lines.push_back({{-wall, -wall}, {wall, -wall}});
  scene.lines.push_back({{wall, -wall}, {wall, wall}});
  scene.lines.push_back({{wall, wall}, {-wall, wall}});
  scene.lines.push_back({{-wall, wall}, {-wall, -wall}});
}

bool isFree(const Scene& scene, Vec position) {
  const OpenArea area = OpenArea::placed(scene.shape, position);
  return std::none_of(scene.lines.begin(), scene.lines.end(),
                      [&](const Segment& line) { return area.intersects(line); });
}

std::string sceneLine(std::string_view keyword, const std::vector<Vec>& vectors) {
  std::string line(keyword);
  for (const Vec v : vectors) line.append(" ").append(std::to_string(v.x)).append(" ").append(std::to_string(v.y));
  return line.append("\n");
}

}  // namespace

Scene randomScene(RandomSource& random) {
  Scene scene;
  while (scene.entities.empty()) {
    scene = {};
    scene.scale = std::int64_t{1} << random.between(4, 22);
    scene.shape = randomShape(kShapes[random.below(kShapes.size())], scene.scale, random);
    if (scene.shape.size() == 16) scene.scale = std::max<std::int64_t>(scene.scale, 1 << 15);
    const Box box = boxOf(scene.shape);
    const Vec centre = halfOf(box.low + box.high);
    for (Vec& corner : scene.shape) corner = corner - centre;
    addLines(scene, random);
    for (std::int64_t i = 0; i < kEntities; ++i)
      if (const Vec place = random.vector(4 * scene.scale); isFree(scene, place)) scene.entities.push_back(place);
  }
  return scene;
}

std::string toText(const Scene& scene) {
  std::string text = sceneLine("shape", scene.shape);
  for (const Segment& line : scene.lines) text += sceneLine("line", {line.a, line.b});
  for (const Vec entity : scene.entities) text += sceneLine("entity", {entity});
  return text;
}

}  // namespace platon::oracle
