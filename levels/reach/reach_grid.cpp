#include "levels/reach/reach_grid.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "levels/reach/flight_envelope.h"
#include "platon/game/player.h"
#include "platon/game/player_motion.h"

namespace platon {
namespace {

constexpr double kRadius = double{1} * kPlayerRadius / kSubunitsPerUnit;
constexpr double kMargin = 0.05;              // of rounding, level units
constexpr double kTouch = kRadius + kMargin;  // a player touches nothing farther away
constexpr double kGoalReach = kTouch + double{1} * kGoalRadius / kSubunitsPerUnit;
// A player stands on what is this much below its centre: a contact at most 62° from straight below.
constexpr double kGroundBelow = 5.5;
// An end that is less below the centre touches the vertical side of the player's shape.
constexpr double kSlowBelow = 2.2;
constexpr double kFlatSlope = 0.005;
constexpr double kVerticalSlope = 100;
// A player moves at most this far in a tick: aside by the slide speed, down by a fast fall. A contact on the way turns
// a displacement (x, y) along a segment, whose part aside is at most (|x| + |(x, y)|) / 2.
constexpr double kSlide = double{1} * motion::kSlideSpeed / kSubunitsPerUnit;
constexpr double kFall = double{1} * motion::kFastFallSpeed / kSubunitsPerUnit;
const Vec kTickReach{(kSlide + std::hypot(kSlide, kFall)) / 2 + kMargin, std::hypot(kSlide, kFall) + kMargin};
// Below this |x|, the unit normal of a segment is vertical: Player sees it rounded to 1 / PlayerState::kUnit.
constexpr double kLevel = 0.4 / PlayerState::kUnit;
// A contact with a larger y is ground.
constexpr double kSteepestGround = (double{1} * motion::kMinGroundNormalY + 1) / PlayerState::kUnit;

// Tangent of the slope whose unit normal has this y.
double slopeWith(double normalY) { return std::sqrt(1 - normalY * normalY) / normalY; }
// Player rounds the normal, so that slopes between both may be ground or steep.
const double kSteepestGroundSlope = slopeWith(kSteepestGroundNormalY);
const double kFlattestSteepSlope = slopeWith(kSteepestGround);

double slopeOf(const Line& line) {
  const Vec along = line.b - line.a;
  if (along.x == 0) return along.y == 0 ? 0 : 1e9;
  return std::abs(along.y / along.x);
}

bool isPoint(const Line& line) { return line.a.x == line.b.x && line.a.y == line.b.y; }

// The part of the line at or below `y`.
std::optional<Line> lowerPart(Line line, double y) {
  if (line.a.y > line.b.y) std::swap(line.a, line.b);
  if (line.a.y > y) return std::nullopt;
  if (line.b.y > y) line.b = line.a + (line.b - line.a) * ((y - line.a.y) / (line.b.y - line.a.y));
  return line;
}

// A contact that is too steep to be ground and pushes the player aside: where its centre may be, and the unit normal.
struct Push {
  Vec normal;
  Rect centres;
};

bool isSteep(Vec normal) { return std::abs(normal.x) > kLevel && normal.y < kSteepestGround; }

Rect common(const Rect& a, const Rect& b) {
  return {{std::max(a.low.x, b.low.x), std::max(a.low.y, b.low.y)},
          {std::min(a.high.x, b.high.x), std::min(a.high.y, b.high.y)}};
}

bool isEmpty(const Rect& rect) { return rect.low.x > rect.high.x || rect.low.y > rect.high.y; }

void addPush(Vec normal, const Line& centres, const Rect& rect, std::vector<Push>& pushes) {
  const Push push{normal, common(boundsOf(centres, {kMargin, kMargin}), rect)};
  if (isSteep(normal) && !isEmpty(push.centres) && distance(rect, centres) <= 2 * kMargin) pushes.push_back(push);
}

// How a segment may push a player whose centre is in the rectangle: an end touches a side of its shape, and the
// segment a vertex of the shape or a side.
std::vector<Push> pushesOf(const Line& line, const Rect& rect) {
  std::vector<Push> pushes;
  if (distance(rect, line) > kTouch) return pushes;
  constexpr int sides = 16;  // of the player's shape
  for (int side = 0; side < sides; ++side) {
    const double angle = side * 2 * std::numbers::pi / sides;
    const Vec normal{std::cos(angle), std::sin(angle)};
    const Vec half = Vec{-normal.y, normal.x} * (kRadius * std::sin(std::numbers::pi / sides));
    for (const Vec end : {line.a, line.b}) {
      const Vec middle = end + normal * kApothemInUnits;
      addPush(normal, {middle - half, middle + half}, rect, pushes);
    }
  }
  if (isPoint(line)) return pushes;
  const Vec along = line.b - line.a;
  for (const double side : {1.0, -1.0}) {
    const Vec normal = Vec{-along.y, along.x} * (side / length(along));
    for (double away = kApothemInUnits; away < kTouch; away += kMargin)
      addPush(normal, {line.a + normal * away, line.b + normal * away}, rect, pushes);
  }
  return pushes;
}

// Whether a player stands that touches first one segment and then, in the same tick, the other one. Between them it
// moves along the first one, perhaps also along a level ceiling, and then into the second one. (A ground on the way
// would carry it anyway.) A segment alone never pushes to both sides: who leaves a convex obstacle does not come back.
bool isWedged(const Push& first, const Push& second) {
  const double side = second.normal.x;
  if (first.normal.x * side > 0 || (first.normal.y <= 0 && second.normal.y <= 0)) return false;
  const Vec least = second.centres.low - first.centres.high;
  const Vec most = second.centres.high - first.centres.low;
  if (side > 0 ? least.x <= 0 : most.x >= 0) return true;
  const auto lesser = [](double factor, double a, double b) { return std::min(factor * a, factor * b); };
  return lesser(second.normal.x, least.x, most.x) + lesser(second.normal.y, least.y, most.y) < 0;
}

// Whether a player with its centre in the cell stands between two of the segments that it may touch in a tick.
bool isWedge(std::span<const ReachWall* const> walls, const Rect& cell) {
  const Rect before{cell.low - kTickReach, cell.high + kTickReach};
  std::vector<std::vector<Push>> pushes;
  for (const ReachWall* const wall : walls) pushes.push_back(pushesOf(wall->line, before));
  for (std::size_t now = 0; now < walls.size(); ++now) {
    for (const Push& second : pushesOf(walls[now]->line, cell)) {
      for (std::size_t i = 0; i < walls.size(); ++i) {
        if (i != now &&
            std::any_of(pushes[i].begin(), pushes[i].end(), [&](const Push& first) { return isWedged(first, second); }))
          return true;
      }
    }
  }
  return false;
}

bool isOneway(const ReachWall& wall) { return wall.kind == ReachWall::Kind::kOneway; }

// The part of `other` in the straight line of `line`, as lengths from its a; nothing if it is elsewhere.
std::optional<std::pair<double, double>> spanAlong(const Line& line, const Line& other) {
  const Vec unit = (line.b - line.a) * (1 / length(line.b - line.a));
  for (const Vec end : {other.a, other.b}) {
    if (std::abs(cross(unit, end - line.a)) > kMargin) return std::nullopt;
  }
  return std::minmax({dot(unit, other.a - line.a), dot(unit, other.b - line.a)});
}

}  // namespace

ReachGrid::ReachGrid(const Level& level, const UprightFaces& faces, std::uint32_t node, double cellSize)
    : cellSize_(cellSize) {
  markInside(faces.all()[node].polygon);
  const std::vector<ReachWall> walls = wallsNear(level, faces, node);
  for (const ReachWall& wall : walls) add(wall);
  addOneways(walls);
  addWedges(walls);
  for (const Place& goal : level.goalPlaces) {
    if (goal.part == faces.all()[node].face) addGoal(uprightOf(goal.position, faces.all()[node].up));
  }
}

Rect ReachGrid::rectOf(std::size_t cell) const {
  const auto column = static_cast<double>(cell % static_cast<std::size_t>(columns_));
  const auto row = static_cast<double>(cell / static_cast<std::size_t>(columns_));
  const Vec low = origin_ + Vec{column, row} * cellSize_;
  return {low, low + Vec{cellSize_, cellSize_}};
}

std::size_t ReachGrid::cellAt(Vec point) const {
  const auto column = static_cast<std::int32_t>(std::floor((point.x - origin_.x) / cellSize_));
  const auto row = static_cast<std::int32_t>(std::floor((point.y - origin_.y) / cellSize_));
  if (column < 0 || row < 0 || column >= columns_ || row >= rows_) return size();
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
}

void ReachGrid::findOverlapped(const Rect& rect, std::vector<std::size_t>& found) const {
  const auto index = [this](double distance) { return static_cast<std::int32_t>(std::floor(distance / cellSize_)); };
  const std::int32_t left = std::max(index(rect.low.x - origin_.x - kMargin), 0);
  const std::int32_t right = std::min(index(rect.high.x - origin_.x + kMargin), columns_ - 1);
  const std::int32_t bottom = std::max(index(rect.low.y - origin_.y - kMargin), 0);
  const std::int32_t top = std::min(index(rect.high.y - origin_.y + kMargin), rows_ - 1);
  for (std::int32_t row = bottom; row <= top; ++row) {
    for (std::int32_t column = left; column <= right; ++column)
      found.push_back(static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                      static_cast<std::size_t>(column));
  }
}

std::span<const ReachWall> ReachGrid::touched(std::size_t cell) const {
  const auto found = touched_.find(cell);
  return found == touched_.end() ? std::span<const ReachWall>() : std::span<const ReachWall>(found->second);
}

void ReachGrid::markInside(const std::vector<Vec>& polygon) {
  Vec high = polygon[0];
  origin_ = polygon[0];
  for (const Vec corner : polygon) {
    origin_ = {std::min(origin_.x, corner.x), std::min(origin_.y, corner.y)};
    high = {std::max(high.x, corner.x), std::max(high.y, corner.y)};
  }
  origin_ = origin_ - Vec{kMargin, kMargin};
  columns_ = static_cast<std::int32_t>(std::ceil((high.x - origin_.x + kMargin) / cellSize_));
  rows_ = static_cast<std::int32_t>(std::ceil((high.y - origin_.y + kMargin) / cellSize_));
  cells_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
  const double half = cellSize_ / 2 * std::sqrt(2.0) + kMargin;
  for (std::size_t cell = 0; cell < size(); ++cell) {
    const Vec middle = rectOf(cell).middle();
    bool inside = true;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vec along = polygon[(i + 1) % polygon.size()] - polygon[i];
      inside = inside && cross(along, middle - polygon[i]) / length(along) > -half;
    }
    cells_[cell].inside = inside;
  }
}

// Visits every cell within `reach` of the bounding box of the line, as visitor(cell, rectangle).
template <class Visitor>
void ReachGrid::visitNear(const Line& line, double reach, Visitor&& visitor) {
  std::vector<std::size_t> near;
  findOverlapped(boundsOf(line, {reach, reach}), near);
  for (const std::size_t cell : near) visitor(cells_[cell], rectOf(cell), cell);
}

void ReachGrid::add(const ReachWall& wall) {
  if (wall.own) addBlocking(wall);
  if (wall.carries) addCarrying(wall);
  if (wall.element == nullptr) return;
  switch (traitsOf(wall.element->kind).effect) {
    case ElementEffect::kNone:
    case ElementEffect::kSendBack:
      return;
    case ElementEffect::kCheckpoint:
    case ElementEffect::kOpen:
    case ElementEffect::kUnlock:
      break;
  }
  visitNear(wall.line, kTouch, [&](Cell&, const Rect& rect, std::size_t cell) {
    if (distance(rect, wall.line) <= kTouch) touched_[cell].push_back(wall);
  });
}

void ReachGrid::addOneways(std::span<const ReachWall> walls) {
  const double most = 3 * cellSize_;
  for (const ReachWall& wall : walls) {
    if (!isOneway(wall)) continue;
    const double own = length(wall.line.b - wall.line.a);
    const Vec unit = (wall.line.b - wall.line.a) * (1 / own);
    ReachOneway oneway;
    double first = 0;
    double last = own;
    for (const ReachWall& other : walls) {
      const bool isFloor = other.kind == ReachWall::Kind::kSolid;
      const auto span = spanAlong(wall.line, other.line);
      const bool isSame = isOneway(other) && dot(other.line.b - other.line.a, unit) > 0;
      if ((!isFloor && !isSame) || !span || span->second < -kMargin || span->first > own + kMargin) continue;
      first = std::min(first, span->first);
      last = std::max(last, span->second);
      if (isFloor) oneway.floors.push_back(other.line);
    }
    oneway.line = {wall.line.a + unit * std::max(first, -most), wall.line.a + unit * std::min(last, own + most)};
    visitNear(oneway.line, kTouch, [&](Cell& cell, const Rect& rect, std::size_t) {
      if (distance(rect, oneway.line) <= kTouch) cell.nearOneway = true;
    });
    oneways_.push_back(std::move(oneway));
  }
}

void ReachGrid::addBlocking(const ReachWall& wall) {
  switch (wall.kind) {
    case ReachWall::Kind::kSolid:
    case ReachWall::Kind::kDoor:
      break;
    case ReachWall::Kind::kTimed:
    case ReachWall::Kind::kOneway:
    case ReachWall::Kind::kTrigger:
      return;
  }
  const double reach = kApothemInUnits - cellSize_ / 2 * std::sqrt(2.0) - kMargin;
  visitNear(wall.line, reach, [&](Cell& cell, const Rect& rect, std::size_t) {
    if (distance(rect.middle(), wall.line) >= reach) return;
    cell.blocked = cell.blocked || wall.kind == ReachWall::Kind::kSolid;
    cell.doors |= wall.doors;
  });
}

void ReachGrid::addCarrying(const ReachWall& wall) {
  const double slope = slopeOf(wall.line);
  if (slope <= kSteepestGroundSlope && !isPoint(wall.line)) addGround(wall.line, slope > kFlatSlope);
  for (const Vec end : {wall.line.a, wall.line.b}) {
    addGround({end, end}, true);
    addSlowing({end, end}, false);
  }
  if (slope >= kFlattestSteepSlope && slope < kVerticalSlope) addSlowing(wall.line, true);
}

void ReachGrid::addGround(const Line& line, bool sloped) {
  visitNear(line, kTouch, [&](Cell& cell, const Rect& rect, std::size_t) {
    const auto below = lowerPart(line, rect.high.y - kGroundBelow);
    if (!below || distance(rect, *below) > kTouch) return;
    cell.grounded = true;
    cell.sloped = cell.sloped || sloped;
    const double top = sloped ? rect.high.y : std::min(rect.high.y, std::max(line.a.y, line.b.y) + kTouch);
    cell.highest = std::max(cell.highest, top);
  });
}

void ReachGrid::addSlowing(const Line& line, bool steep) {
  visitNear(line, kTouch, [&](Cell& cell, const Rect& rect, std::size_t) {
    const auto below = lowerPart(line, rect.high.y - (steep ? 0 : kSlowBelow));
    if (!below || distance(rect, *below) > kTouch) return;
    cell.slowed = true;
    cell.steep = cell.steep || steep;
    if (steep) cell.flattest = std::min(cell.flattest, std::max(slopeOf(line), kFlattestSteepSlope));
  });
}

// A player that touches two segments in one tick, one on its left and one on its right, stands if one of them pushes it
// up: Player::standInWedge. The cell is the one in which it touches the second of them; it was at most a tick away when
// it touched the first.
void ReachGrid::addWedges(std::span<const ReachWall> walls) {
  struct Near {
    std::vector<const ReachWall*> inTick;
    bool isTouched = false;
  };
  std::vector<Near> near(size());
  for (const ReachWall& wall : walls) {
    if (!wall.carries) continue;
    visitNear(wall.line, kTouch + kTickReach.y, [&](Cell& cell, const Rect& rect, std::size_t index) {
      if (!cell.inside || cell.blocked || distance(rect, wall.line) > kTouch + length(kTickReach)) return;
      near[index].inTick.push_back(&wall);
      near[index].isTouched = near[index].isTouched || distance(rect, wall.line) <= kTouch;
    });
  }
  for (std::size_t i = 0; i < size(); ++i) {
    if (!near[i].isTouched || near[i].inTick.size() < 2 || !isWedge(near[i].inTick, rectOf(i))) continue;
    cells_[i].grounded = cells_[i].sloped = true;
    cells_[i].highest = std::max(cells_[i].highest, rectOf(i).high.y);
  }
}

void ReachGrid::addGoal(Vec goal) {
  visitNear({goal, goal}, kGoalReach, [&](Cell& cell, const Rect& rect, std::size_t) {
    if (distance(rect, {goal, goal}) <= kGoalReach) cell.atGoal = true;
  });
}

}  // namespace platon
