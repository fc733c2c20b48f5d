#include "platon/game/stage.h"

#include "platon/exact/integer.h"
#include "platon/game/player.h"
#include "platon/physics/map_part.h"
#include "platon/physics/rules.h"

namespace platon {
namespace {

Point alongEdge(Point corner, Point other, std::int64_t edgeLength) {
  const auto reach = [&](std::int32_t from, std::int32_t to) {
    return static_cast<std::int32_t>(divideRounded((std::int64_t{to} - from) * kPostReach, edgeLength));
  };
  return corner + Point(reach(corner.x, other.x), reach(corner.y, other.y));
}

void addWarps(MapPart& part, SolidKind kind, std::int32_t faceSize, const std::vector<Point>& polygon) {
  const PlatonicSolid& solid = PlatonicSolid::of(kind);
  const auto corner = [&](int index) { return polygon[static_cast<std::size_t>(index) % polygon.size()]; };
  for (int edge = 0; edge < solid.edgesPerFace(); ++edge) {
    const PlatonicSolid::Neighbour& behind = solid.neighbour(static_cast<int>(part.id()), edge);
    part.warp({corner(edge), corner(edge + 1)}, behind.face, {corner(behind.edge + 1), corner(behind.edge)},
              edgeMiddle(kind, faceSize, edge), edgeMiddle(kind, faceSize, behind.edge));
  }
}

// Everything blocks that can block at any time.
class AllBlock : public Rules {
 public:
  explicit AllBlock(std::span<const Element> elements) : elements_(elements) {}
  Scope scope() const override { return elements_.empty() ? Scope::kContacts : Scope::kSegments; }
  bool pierce(const Entity&, const SegmentRef& segment) const override {
    const Element* const element = findElement(elements_, segment.part, segment.index);
    return element != nullptr && !canBlock(element->kind);
  }

 private:
  std::span<const Element> elements_;
};

}  // namespace

std::vector<Post> postsOf(SolidKind kind, std::int32_t faceSize) {
  const std::vector<Point> polygon = facePolygon(kind, faceSize);
  const std::int64_t edgeLength = std::int64_t{faceSize} * kSubunitsPerUnit;
  const std::size_t count = polygon.size();
  std::vector<Post> posts;
  for (std::size_t i = 0; i < count; ++i) {
    const Point before = alongEdge(polygon[i], polygon[(i + count - 1) % count], edgeLength);
    const Point after = alongEdge(polygon[i], polygon[(i + 1) % count], edgeLength);
    posts.push_back({{before, after}, polygon[i]});
  }
  return posts;
}

World buildStage(SolidKind kind, std::int32_t faceSize, std::span<const std::vector<Segment>> segments) {
  World world;
  const PlatonicSolid& solid = PlatonicSolid::of(kind);
  const std::vector<Point> polygon = facePolygon(kind, faceSize);
  const std::vector<Post> posts = postsOf(kind, faceSize);
  for (int face = 0; face < solid.faces(); ++face) {
    MapPart part(world, static_cast<std::uint32_t>(face));
    for (const Segment& segment : segments[static_cast<std::size_t>(face)]) part.line(segment.a, segment.b);
    for (const Post& post : posts) {
      part.line(post.cut.a, post.cut.b);
      part.line(post.corner, post.corner);
    }
    addWarps(part, kind, faceSize, polygon);
    part.initialize();
  }
  return world;
}

bool isFreeForPlayer(const World& world, std::span<const Element> elements, std::uint32_t face, Point position,
                     Angle angle) {
  AllBlock rules(elements);
  return world.canPlace(face, playerShape(), position, angle, rules);
}

}  // namespace platon
