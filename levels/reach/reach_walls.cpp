#include "levels/reach/reach_walls.h"

#include <algorithm>

#include "platon/game/stage.h"

namespace platon {
namespace {

constexpr double kNear = 32;  // from the face, level units: more than the reach of ball and goal

Rect boundsOf(const std::vector<Vec>& points) {
  Rect bounds{points[0], points[0]};
  for (const Vec point : points) {
    bounds.low = {std::min(bounds.low.x, point.x), std::min(bounds.low.y, point.y)};
    bounds.high = {std::max(bounds.high.x, point.x), std::max(bounds.high.y, point.y)};
  }
  return bounds;
}

class WallList {
 public:
  WallList(const Level& level, const UprightFaces& faces, std::uint32_t node)
      : level_(level),
        faces_(faces),
        posts_(postsOf(level.solid, level.faceSize)),
        bounds_(boundsOf(faces.all()[node].polygon)) {
    bounds_.low = bounds_.low - Vec{kNear, kNear};
    bounds_.high = bounds_.high + Vec{kNear, kNear};
    append(node, {}, true);
    for (const auto& next : faces.all()[node].neighbours) {
      append(next.node, next.shift, false);
      for (const auto& further : faces.all()[next.node].neighbours) {
        if (further.node != node) append(further.node, next.shift + further.shift, false);
      }
    }
  }

  std::vector<ReachWall> take() { return std::move(walls_); }

 private:
  // `shift` leads from the frame of the list to that of `node`.
  void append(std::uint32_t node, Vec shift, bool own) {
    const UprightFace& face = faces_.all()[node];
    const auto& segments = level_.segments[face.face];
    const auto add = [&](const Segment& segment, const Element* element, bool blocks) {
      ReachWall wall;
      wall.line = {uprightOf(segment.a, face.up) - shift, uprightOf(segment.b, face.up) - shift};
      wall.own = blocks;
      wall.element = element;
      wall.node = node;
      if (distance(bounds_, wall.line) == 0 && describe(wall, face)) walls_.push_back(wall);
    };
    for (std::uint32_t i = 0; i < segments.size(); ++i)
      add(segments[i], findElement(level_.elements, face.face, i), own);
    for (const Post& post : posts_) {
      add(post.cut, nullptr, false);
      add({post.corner, post.corner}, nullptr, false);
    }
  }

  // Whether the segment matters to a player with this up.
  bool describe(ReachWall& wall, const UprightFace& face) const {
    if (wall.element == nullptr) return true;
    switch (wall.element->kind) {
      case ElementKind::kUp:
        return pointsTo(face.up, *wall.element, static_cast<std::int32_t>(face.polygon.size()));
      case ElementKind::kOneway:
        wall.kind = ReachWall::Kind::kOneway;
        return true;
      case ElementKind::kHazard:
        wall.carries = false;
        return true;
      case ElementKind::kDoor:
        wall.kind = ReachWall::Kind::kDoor;
        wall.doors = wall.element->bit();
        return true;
      case ElementKind::kTimed:
        wall.kind = ReachWall::Kind::kTimed;
        return true;
      case ElementKind::kCheckpoint:
      case ElementKind::kKey:
        wall.kind = ReachWall::Kind::kTrigger;
        wall.carries = false;
        return true;
      case ElementKind::kPlate:
        return true;
    }
    return true;
  }

  const Level& level_;
  const UprightFaces& faces_;
  std::vector<Post> posts_;
  Rect bounds_;
  std::vector<ReachWall> walls_;
};

}  // namespace

std::vector<ReachWall> wallsNear(const Level& level, const UprightFaces& faces, std::uint32_t node) {
  return WallList(level, faces, node).take();
}

}  // namespace platon
