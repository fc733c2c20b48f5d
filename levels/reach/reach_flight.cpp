#include "levels/reach/reach_flight.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "platon/game/player.h"

namespace platon {
namespace {

constexpr double kOnewayRounding = 0.0375;  // level units
// A player on the left of a one-way segment is at least this far from it.
constexpr double kOnewayDistance = kApothemInUnits - double{1} * kOnewaySlack / kSubunitsPerUnit - kOnewayRounding;
// Rounding of positions and ticks.
constexpr double kSideways = 1;
constexpr int kTicks = 2;
// At the ends of segments, a player falls at this share of its speed at least: 1 - sin²(22.5°).
constexpr double kSlowestFall = 0.85;

// The line between two neighbouring cells.
Line boundaryOf(const Rect& from, const Rect& to) {
  const Vec low{std::max(from.low.x, to.low.x), std::max(from.low.y, to.low.y)};
  const Vec high{std::min(from.high.x, to.high.x), std::min(from.high.y, to.high.y)};
  return {low, high};
}

double leftOf(const Line& line, Vec point) {
  const Vec along = line.b - line.a;
  return ::platon::cross(along, point - line.a) / length(along);
}

std::array<Vec, 4> cornersOf(const Rect& cell) {
  return {cell.low, {cell.high.x, cell.low.y}, cell.high, {cell.low.x, cell.high.y}};
}

double leastLeftOf(const Line& line, const Rect& cell) {
  double least = 1e300;
  for (const Vec corner : cornersOf(cell)) least = std::min(least, leftOf(line, corner));
  return least;
}

bool isBeside(const Line& line, Vec point) {
  const Vec along = line.b - line.a;
  const double t = dot(point - line.a, along);
  return t >= 0 && t <= dot(along, along);
}

// Whether a player that overlaps no one-way segment cannot move over the boundary from `from` to `to`: it would enter
// this segment from the left.
bool isStoppedBy(const Line& oneway, const Rect& from, const Rect& to) {
  const Line boundary = boundaryOf(from, to);
  if (!isBeside(oneway, boundary.a) || !isBeside(oneway, boundary.b)) return false;
  return leastLeftOf(oneway, from) > 0 && leftOf(oneway, to.middle()) < leftOf(oneway, from.middle()) &&
         std::max(leftOf(oneway, boundary.a), leftOf(oneway, boundary.b)) < kOnewayDistance;
}

// Whether the cell is on the left of the segment and beside it.
bool isOnLeft(const Line& line, const Rect& cell) {
  const auto corners = cornersOf(cell);
  return leastLeftOf(line, cell) > 0 &&
         std::all_of(corners.begin(), corners.end(), [&](Vec corner) { return isBeside(line, corner); });
}

// Whether a wall keeps a player with its centre in the cell on the left of the one-way segment.
bool isHeld(const ReachOneway& oneway, const Rect& cell) {
  return std::any_of(oneway.floors.begin(), oneway.floors.end(),
                     [&](const Line& floor) {
                       return isOnLeft(floor, cell) || isOnLeft({floor.b, floor.a}, cell);
                     }) &&
         leastLeftOf(oneway.line, cell) > 0;
}

// Whether a player with its centre in the cell may overlap the segment although it has not entered it from the left.
bool mayOverlap(const ReachOneway& oneway, const Rect& cell) {
  return distance(cell, oneway.line) < kApothemInUnits + 0.5 && leastLeftOf(oneway.line, cell) < kOnewayDistance &&
         !isHeld(oneway, cell);
}

// Whether a player with its centre in the cell may be wholly on the left of the segment, or away from it.
bool mayBeFree(const Line& oneway, const Rect& cell) {
  double farthest = -1e300;
  for (const Vec corner : cornersOf(cell)) farthest = std::max(farthest, leftOf(oneway, corner));
  return farthest >= kOnewayDistance || distance(cell, oneway) >= kApothemInUnits - 3;
}

}  // namespace

ReachFlight::ReachFlight(const World& world, const ReachLaunch& launch, int crossings)
    : world_(world), crossings_(crossings) {
  prepare(launch);
  const std::uint32_t sheet = sheetOf(launch.node, {});
  for (const std::uint32_t cell : launch.cells)
    enter(crossings, {sheet, cell, launch.rising ? Motion::kDip : Motion::kFall, launch.inOneway});
}

ReachFlight::ReachFlight(const World& world, const ReachLaunch& launch, std::span<const ReachVisit> visited)
    : world_(world), crossings_(visited.front().crossings) {
  prepare(launch);
  for (const ReachVisit& visit : visited)
    enter(visit.crossings, {sheetOf(visit.node, visit.shift), visit.cell, visit.motion, visit.inOneway});
}

void ReachFlight::prepare(const ReachLaunch& launch) {
  const ReachGrid& grid = *world_.grids[launch.node];
  const Rect first = grid.rectOf(launch.cells.front());
  left_ = first.low.x;
  right_ = grid.rectOf(launch.cells.back()).high.x;
  apex_ = launch.apex;
  speed_ = launch.speed;
  low_ = first.low.y;
  launchTicks_ = kTicks;
  if (launch.rising) launchTicks_ += envelope_.riseTicks(apex_ - first.low.y) + envelope_.lateTicks();
}

void ReachFlight::spread(const State& state) {
  const ReachGrid& grid = gridOf(state);
  const auto columns = static_cast<std::size_t>(grid.columns());
  const std::size_t column = state.cell % columns;
  const bool rises = state.motion == Motion::kRise;
  if (rises) enter(crossings_, {state.sheet, state.cell, Motion::kFall, state.inOneway});
  if (state.motion == Motion::kDip) enter(crossings_, {state.sheet, state.cell, Motion::kRise, state.inOneway});
  if (rises && state.cell + columns < grid.size()) step(state, state.cell + columns);
  if (!rises && state.cell >= columns) step(state, state.cell - columns);
  if (column > 0) step(state, state.cell - 1U);
  if (column + 1 < columns) step(state, state.cell + 1U);
  cross(state);
}

// Moves to a neighbouring cell.
void ReachFlight::step(const State& from, std::size_t cell) {
  const ReachGrid& grid = gridOf(from);
  if (!grid[cell].inside) return;
  State next{from.sheet, static_cast<std::uint32_t>(cell), from.motion, from.inOneway};
  if (grid[cell].nearOneway || grid[from.cell].nearOneway) {
    const Rect before = grid.rectOf(from.cell);
    const Rect after = grid.rectOf(cell);
    bool overlaps = false;
    bool isFree = true;
    for (const ReachOneway& oneway : grid.oneways()) {
      if (!from.inOneway && isStoppedBy(oneway.line, before, after)) return;
      overlaps = overlaps || ((from.inOneway || !isOnLeft(oneway.line, before)) && mayOverlap(oneway, after));
      isFree = isFree && mayBeFree(oneway.line, after);
    }
    next.inOneway = overlaps;
    if (isFree && overlaps) enter(crossings_, {next.sheet, next.cell, next.motion, false});
  } else {
    next.inOneway = false;
  }
  enter(crossings_, next);
}

// Moves over the edges of the face behind which the cell reaches.
void ReachFlight::cross(const State& from) {
  const Sheet& sheet = sheets_[from.sheet];
  const UprightFace& face = world_.faces.all()[sheet.node];
  const Rect rect = gridOf(from).rectOf(from.cell);
  const std::uint32_t node = sheet.node;
  const Vec shift = sheet.shift;
  const double reach = length(rect.high - rect.low) / 2;
  for (std::size_t edge = 0; edge < face.polygon.size(); ++edge) {
    const Line line{face.polygon[edge], face.polygon[(edge + 1) % face.polygon.size()]};
    if (distance(rect.middle(), line) > reach + 0.1) continue;
    const auto& behind = world_.faces.all()[node].neighbours[edge];
    const std::uint32_t next = sheetOf(behind.node, shift + behind.shift);
    std::vector<std::size_t> cells;
    world_.grids[behind.node]->findOverlapped({rect.low + behind.shift, rect.high + behind.shift}, cells);
    for (const std::size_t cell : cells) {
      enter(crossings_ + 1, {next, static_cast<std::uint32_t>(cell), from.motion, from.inOneway});
      if (from.inOneway) enter(crossings_ + 1, {next, static_cast<std::uint32_t>(cell), from.motion, false});
    }
  }
}

void ReachFlight::enter(int crossings, const State& state) {
  std::uint8_t& seen = sheets_[state.sheet].seen[state.cell];
  const auto bit = static_cast<std::uint8_t>(1 << (2 * static_cast<int>(state.motion) + (state.inOneway ? 1 : 0)));
  if ((seen & bit) != 0 || !isFree(state) || !isInTime(crossings, state)) return;
  seen = static_cast<std::uint8_t>(seen | bit);
  (crossings == crossings_ && isRunning_ ? open_ : waiting_).push_back(state);
}

bool ReachFlight::isFree(const State& state) const {
  const ReachGrid::Cell& cell = gridOf(state)[state.cell];
  return cell.inside && !cell.blocked && (cell.doors & ~world_.open) == 0;
}

// How far beside the launch the cell is.
double ReachFlight::asideOf(const State& state) const {
  const Rect rect = gridOf(state).rectOf(state.cell);
  const double shift = sheets_[state.sheet].shift.x;
  return std::max({left_ - (rect.high.x - shift), rect.low.x - shift - right_, 0.0});
}

// A fall from rest takes at least as long as the rest of this one, but for the ticks until this one began.
bool ReachFlight::isBelow(const State& state) const {
  return state.motion != Motion::kRise && asideOf(state) <= envelope_.wayAside(launchTicks_, speed_);
}

// Whether the flight can be in the cell in time, and no flight is known that can do as much from there.
bool ReachFlight::isInTime(int crossings, const State& state) {
  const Sheet& sheet = sheets_[state.sheet];
  const double y = gridOf(state).rectOf(state.cell).low.y - sheet.shift.y;
  if (y > apex_) return false;
  if (state.motion == Motion::kDip) return isInTimeForALateJump(state);
  const bool rises = state.motion == Motion::kRise;
  const int ticks = launchTicks_ + (rises ? 0 : envelope_.fallTicks((apex_ - y) / kSlowestFall));
  const double sideways = envelope_.wayAside(ticks, speed_) + kSideways;
  if (asideOf(state) > sideways) return false;
  if (state.inOneway) return true;
  ReachKnown& known = world_.known[sheet.node][2 * state.cell + (rises ? 1U : 0U)];
  const auto left = static_cast<float>(left_ - sideways + sheet.shift.x);
  const auto right = static_cast<float>(right_ + sideways + sheet.shift.x);
  const auto apex = static_cast<float>(apex_ + sheet.shift.y);
  const auto speed = static_cast<float>(envelope_.speedAfter(ticks, speed_));
  const auto landing = static_cast<float>(speedIn(state));
  const bool goesAsFar = rises ? known.apex >= apex : known.apex <= apex;
  if (known.crossings <= crossings && known.left <= left && known.right >= right && known.speed >= speed &&
      known.landing >= landing && goesAsFar)
    return false;
  known = {left, right, apex, speed, landing, static_cast<std::uint8_t>(crossings)};
  return true;
}

bool ReachFlight::isInTimeForALateJump(const State& state) const {
  const double top = gridOf(state).rectOf(state.cell).high.y - sheets_[state.sheet].shift.y;
  const double down = std::max(0.0, low_ - top - envelope_.lateFall());
  const double aside = std::max(0.0, asideOf(state) - kSideways);
  const double way = envelope_.lateWay(speed_);
  return down <= way * envelope_.steepestRise() && length({aside, down}) <= way;
}

std::uint32_t ReachFlight::sheetOf(std::uint32_t node, Vec shift) {
  constexpr double same = 0.5;
  for (std::uint32_t i = 0; i < sheets_.size(); ++i) {
    if (sheets_[i].node == node && length(sheets_[i].shift - shift) < same) return i;
  }
  sheets_.push_back({node, shift, std::vector<std::uint8_t>(world_.grids[node]->size())});
  return static_cast<std::uint32_t>(sheets_.size() - 1);
}

}  // namespace platon
