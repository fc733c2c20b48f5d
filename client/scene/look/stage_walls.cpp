#include "client/scene/look/stage_walls.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace platon {
namespace {

constexpr double kWidth = StageModel::kRibbonWidth;
constexpr double kLow = 3;          // height of an open door, level units
constexpr double kLedge = 4;        // height of a oneway
constexpr double kFence = 8;        // height of a hazard
constexpr double kMaxPieces = 256;  // of an element

const Colour kGold(0.95F, 0.72F, 0.28F);
const Colour kRed(1.0F, 0.40F, 0.34F);
const Colour kViolet(0.74F, 0.55F, 0.95F);
const Colour kBlue(0.62F, 0.80F, 0.98F);

// The walls of one element.
class ElementWalls {
 public:
  ElementWalls(const ElementDrawing& drawing, double active, Colour wall, std::vector<Wall>& walls)
      : active_(active),
        wall_(wall),
        walls_(walls),
        from_(drawing.ends.a),
        length_(glm::distance(drawing.ends.a, drawing.ends.b)) {
    along_ = length_ > 0 ? (glm::dvec2(drawing.ends.b) - from_) / length_ : glm::dvec2(1, 0);
  }

  void add(ElementKind kind) {
    switch (kind) {
      case ElementKind::kOneway:
        return addRod({0, 0}, {length_, 0}, kWidth / 3, kLedge, wall_);
      case ElementKind::kUp:
        return addBlocks();
      case ElementKind::kHazard:
        return addZigzag();
      case ElementKind::kDoor:
        return addRails();
      case ElementKind::kPlate:
        return addPlate();
      case ElementKind::kCheckpoint:
      case ElementKind::kKey:
        return;
    }
  }

 private:
  // `from` and `to`: x along the segment, y to its left.
  void addRod(glm::dvec2 from, glm::dvec2 to, double halfWidth, double height, Colour colour) {
    walls_.push_back({at(from), at(to), halfWidth, height, colour});
  }

  glm::dvec2 at(glm::dvec2 place) const { return from_ + place.x * along_ + place.y * glm::dvec2(-along_.y, along_.x); }

  double pieces(double gap) const { return std::clamp(std::floor(length_ / gap), 1.0, kMaxPieces); }

  // What lets pass is hollow, and no wall.
  void addBlocks() {
    if (active_ <= 0) return;
    const double count = pieces(4 * kWidth);
    const double gap = length_ / count;
    const double half = std::max(0.33 * gap - kWidth / 2, 0.0);
    for (double i = 0.5; i < count; ++i) {
      addRod({i * gap - half, 0}, {i * gap + half, 0}, kWidth / 2, active_ * Wall::kHeight, kBlue);
    }
  }

  void addZigzag() {
    const double count = pieces(2 * kWidth);
    const double gap = length_ / count;
    const double aside = 1.5 * kWidth;
    for (double i = 0; i < count; ++i) {
      const double side = std::fmod(i, 2) == 0 ? aside : -aside;
      addRod({i * gap, -side}, {(i + 1) * gap, side}, 0.45 * kWidth, kFence, kRed);
    }
  }

  void addRails() {
    const double leaf = glm::mix(std::min(2.5 * kWidth, length_ / 2), length_ / 2, active_);
    const double height = glm::mix(kLow, Wall::kHeight, active_);
    for (const double side : {-kWidth, kWidth}) {
      if (active_ >= 1) {
        addRod({0, side}, {length_, side}, 0.4 * kWidth, height, kGold);
      } else {
        addRod({0, side}, {leaf, side}, 0.4 * kWidth, height, kGold);
        addRod({length_ - leaf, side}, {length_, side}, 0.4 * kWidth, height, kGold);
      }
    }
  }

  void addPlate() {
    const double high = glm::mix(1.6, 0.7, active_) * kWidth;
    const double thick = glm::mix(1.0, 0.55, active_) * kWidth;
    addRod({0, 0}, {length_, 0}, 0.4 * kWidth, Wall::kHeight, wall_);
    const double margin = std::min(0.15 * length_ + high, length_ / 2);
    addRod({margin, high}, {length_ - margin, high}, thick, glm::mix(Wall::kHeight, kFence, active_), kViolet);
  }

  double active_;  // 0 … 1
  Colour wall_;
  std::vector<Wall>& walls_;
  glm::dvec2 from_;
  double length_;
  glm::dvec2 along_{1, 0};
};

}  // namespace

std::vector<std::vector<Wall>> wallsOf(const StageModel& stage) {
  std::vector<std::vector<Wall>> walls;
  for (const FaceDrawing& face : stage.faces) {
    walls.emplace_back();
    for (const Ribbon& ends : face.ribbons)
      walls.back().push_back({ends.a, ends.b, kWidth / 2, Wall::kHeight, stage.scheme().wall});
  }
  return walls;
}

std::vector<std::vector<Wall>> elementWallsOf(const StageModel& stage, std::span<const double> shares) {
  std::vector<std::vector<Wall>> walls;
  for (const FaceDrawing& face : stage.faces) {
    walls.emplace_back();
    for (const ElementDrawing& drawing : face.elements) {
      ElementWalls(drawing, shares[drawing.element], stage.scheme().wall, walls.back()).add(drawing.kind);
    }
  }
  return walls;
}

EdgeMeetings edgeMeetingsOf(const StageModel& stage) {
  std::vector<std::vector<Wall>> walls = wallsOf(stage);
  for (std::size_t face = 0; face < walls.size(); ++face) {
    for (const ElementDrawing& drawing : stage.faces[face].elements) {
      if (!canBlock(drawing.kind)) continue;
      walls[face].push_back({drawing.ends.a, drawing.ends.b});
    }
  }
  return {stage.mesh, walls};
}

}  // namespace platon
