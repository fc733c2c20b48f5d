#include "client/demo/demo.h"

#include <algorithm>
#include <cstdlib>

#include "platon/game/player_motion.h"
#include "platon/physics/sweep.h"

namespace platon {

namespace {

constexpr std::int32_t kMinCellSize = 12 * kSubunitsPerUnit;
constexpr std::int32_t kMaxCells = 8000;

Convex square(std::int32_t r) { return Convex(std::vector<Point>{{-r, -r}, {r, -r}, {r, r}, {-r, r}}); }

// The square that must fit between segments. It is smaller than the ball, because cell centres rarely lie in the middle
// of a gap. At a source it is almost a point, because the goal may touch a segment.
const Convex& probeFor(bool atSource) {
  static const Convex kSmallBall = square(4 * kSubunitsPerUnit);
  static const Convex kPoint = square(16);
  return atSource ? kPoint : kSmallBall;
}

// What is in the way of a player who comes from a place, while these doors are open.
struct Obstacles {
  const Level& level;
  std::uint32_t open;

  bool block(std::uint32_t face, std::uint32_t segment, Point player) const {
    const Element* const element = findElement(level.elements, face, segment);
    if (element == nullptr) return true;
    switch (element->kind) {
      case ElementKind::kOneway:
        return cross(element->ends.b - element->ends.a, player - element->ends.a) > 0;
      case ElementKind::kUp:
        return false;
      case ElementKind::kDoor:
        return (open & element->bit()) == 0;
      case ElementKind::kHazard:
      case ElementKind::kPlate:
        return true;
      case ElementKind::kCheckpoint:
      case ElementKind::kKey:
      case ElementKind::kTimed:
        return false;
    }
    return true;
  }
};

// Approximate length, error at most 8 %.
std::int32_t roughLengthOf(Point vector) {
  const std::int32_t x = std::abs(vector.x);
  const std::int32_t y = std::abs(vector.y);
  return std::max(x, y) + std::min(x, y) * 2 / 5;
}

// Whether a player can move from `to` to `from`.
bool isFree(const Convex& probe, const Obstacles& obstacles, std::uint32_t face, Point from, Point to) {
  const MapGeometry& part = *obstacles.level.world.geometry().find(face);
  Sweep sweep;
  sweep.start(probe, from, to - from);
  std::vector<std::uint32_t> segments;
  part.grid.query(sweep.bounds(), segments);
  return std::none_of(segments.begin(), segments.end(), [&](std::uint32_t segment) {
    return !part.isWarp(segment) && obstacles.block(face, segment, to) &&
           sweep.against(part.segments[segment]).has_value();
  });
}

const Warp* warpBehind(const MapGeometry& part, Point point) {
  for (const Warp& warp : part.warps) {
    if (cross(warp.from.b - warp.from.a, point - warp.from.a) < 0) return &warp;
  }
  return nullptr;
}

// The place from which a straight path across at most one edge leads to `from`; nothing if a segment blocks it.
std::optional<Place> reach(const Convex& probe, const Obstacles& obstacles, std::uint32_t face, Point from, Point to) {
  const Geometry& geometry = obstacles.level.world.geometry();
  if (!isFree(probe, obstacles, face, from, to)) return std::nullopt;
  const Warp* const warp = warpBehind(*geometry.find(face), to);
  if (warp == nullptr) return Place{face, to};
  const auto beyond = [warp](Point point) { return rounded(warp->map(precise(point))); };
  if (!isFree(probe, obstacles, warp->target, beyond(from), beyond(to))) return std::nullopt;
  if (warpBehind(*geometry.find(warp->target), beyond(to)) != nullptr) return std::nullopt;
  return Place{warp->target, beyond(to)};
}

std::int32_t farthestCoordinate(const Geometry& geometry) {
  std::int32_t farthest = 0;
  for (const auto& part : geometry.parts) {
    for (const Warp& warp : part->warps) {
      farthest = std::max({farthest, std::abs(warp.from.a.x), std::abs(warp.from.a.y)});
    }
  }
  return farthest;
}

std::int32_t cellsPerAxis(std::size_t faces) {
  std::int32_t side = 1;
  while ((side + 2) * (side + 2) * static_cast<std::int32_t>(faces) <= kMaxCells) side += 2;
  return side;
}

}  // namespace

GoalDistance::GoalDistance(const Level& level) : level_(&level) {
  const Geometry& geometry = level.world.geometry();
  const std::int32_t half = farthestCoordinate(geometry);
  cellSize_ = std::max(kMinCellSize, 2 * half / cellsPerAxis(geometry.parts.size()) + 1);
  side_ = 2 * ((half + cellSize_ / 2) / cellSize_) + 1;
}

const GoalDistance::Grid& GoalDistance::gridFor(std::uint32_t open) {
  const auto known = grids_.find(open);
  return known != grids_.end() ? known->second : grids_.emplace(open, spread(open, sources(open))).first->second;
}

// The goal, and the keys that have not been taken.
std::vector<GoalDistance::Reached> GoalDistance::sources(std::uint32_t open) {
  std::vector<Reached> sources = {{0, {level_->goalFace, level_->goal}}};
  for (const Element& element : level_->elements) {
    if (!unlocksDoors(element.kind) || (open & element.bit()) != 0) continue;
    const Place key{element.face, placeOf(element)};
    const std::int32_t left = distanceOn(gridFor(level_->doorNumbers), key);
    if (left != kUnreachable) sources.push_back({left, key});
  }
  return sources;
}

bool GoalDistance::onGrid(const Cell& cell) const {
  return cell.column >= 0 && cell.row >= 0 && cell.column < side_ && cell.row < side_;
}

std::size_t GoalDistance::indexOf(const Cell& cell) const {
  return (cell.face * static_cast<std::size_t>(side_) + static_cast<std::size_t>(cell.row)) *
             static_cast<std::size_t>(side_) +
         static_cast<std::size_t>(cell.column);
}

Point GoalDistance::centreOf(const Cell& cell) const {
  return {(cell.column - side_ / 2) * cellSize_, (cell.row - side_ / 2) * cellSize_};
}

GoalDistance::Cell GoalDistance::cellAt(const Place& place) const {
  const auto nearest = [this](std::int32_t coordinate) {
    return std::clamp(divideRounded(coordinate, cellSize_) + side_ / 2, 0, side_ - 1);
  };
  return {place.part, nearest(place.position.x), nearest(place.position.y)};
}

GoalDistance::Grid GoalDistance::spread(std::uint32_t open, const std::vector<Reached>& sources) const {
  const auto farther = [](const Reached& a, const Reached& b) { return a.distance > b.distance; };
  Grid grid(level_->segments.size() * static_cast<std::size_t>(side_ * side_), kUnreachable);
  std::vector<Reached> front;
  for (const Reached& source : sources) spreadFrom(source, true, open, grid, front);
  std::make_heap(front.begin(), front.end(), farther);
  while (!front.empty()) {
    std::pop_heap(front.begin(), front.end(), farther);
    const Reached reached = front.back();
    front.pop_back();
    if (reached.distance > lookUp(grid, cellAt(reached.place))) continue;
    const std::size_t known = front.size();
    spreadFrom(reached, false, open, grid, front);
    for (std::size_t i = known + 1; i <= front.size(); ++i) {
      std::push_heap(front.begin(), front.begin() + static_cast<std::ptrdiff_t>(i), farther);
    }
  }
  return grid;
}

void GoalDistance::spreadFrom(const Reached& reached, bool isSource, std::uint32_t open, Grid& grid,
                              std::vector<Reached>& front) const {
  const Point from = reached.place.position;
  const Cell middle = cellAt(reached.place);
  for (std::int32_t i = 0; i < 9; ++i) {
    const Point to = centreOf({middle.face, middle.column + i % 3 - 1, middle.row + i / 3 - 1});
    const std::optional<Place> place = reach(probeFor(isSource), {*level_, open}, middle.face, from, to);
    if (!place) continue;
    const Cell cell = cellAt(*place);
    const std::int32_t distance = reached.distance + roughLengthOf(to - from);
    if (distance >= lookUp(grid, cell)) continue;
    grid[indexOf(cell)] = distance;
    front.push_back({distance, {cell.face, centreOf(cell)}});
  }
}

std::int32_t GoalDistance::from(const Place& place, std::uint32_t open) { return distanceOn(gridFor(open), place); }

std::int32_t GoalDistance::distanceOn(const Grid& grid, const Place& place) const {
  const Cell middle = cellAt(place);
  std::int32_t best = kUnreachable;
  // Also tries the neighbouring cells: a floor can separate the place from the centre of its own cell.
  for (std::int32_t i = 0; i < 9; ++i) {
    const Cell cell{middle.face, middle.column + i % 3 - 1, middle.row + i / 3 - 1};
    const std::int32_t beyond = lookUp(grid, cell);
    if (beyond == kUnreachable) continue;
    best = std::min(best, beyond + roughLengthOf(centreOf(cell) - place.position));
  }
  return best;
}

namespace {

constexpr std::uint32_t kTicksOfRest = 10;  // longer than a jump press is buffered
constexpr std::uint32_t kMaxTicksOfRest = kTicksPerSecond;
constexpr std::uint32_t kMaxTicksToRest = 5 * kTicksPerSecond;
constexpr std::size_t kMaxStates = 400000;  // of a search: some 100 MB
constexpr std::int32_t kHaste = 2;          // weight of the ticks that are left against those of the way
constexpr std::uint32_t kFar = 1U << 30;    // ticks to a goal that is not reached along the surface

Input pressing(Input input, std::uint8_t button) { return {static_cast<std::uint8_t>(input.buttons | button)}; }

}  // namespace

Demo::Motion Demo::motionOf(const Game& game, std::uint32_t slot) {
  const EntityState& entity = game.world().entities()[slot];
  return {entity.part, entity.position, game.player(slot).velocity, entity.angle};
}

Input Demo::choose(const Game& game, std::uint32_t slot) {
  if (game.sharedLevel() != level_ || game.tick() < tick_) startRound(game);
  tick_ = game.tick();
  if (slot >= game.slots() || game.player(slot).present == 0 || game.over()) return {};
  // On the way, another player may need this one.
  if (game.player(slot).finished() && (!way_ || level_->players == 1)) return {};
  const Motion now = motionOf(game, slot);
  restingTicks_ = last_ == now ? restingTicks_ + 1 : 0;
  last_ = now;
  const bool isAsPlanned = step_ < plan_.size() && now == expected_[step_];
  if (isAsPlanned && !isCommonStart(tick_) && !waitsInVain(game)) return plan_[step_++];
  plan_.clear();
  return way_ ? beginWay(game, slot) : waitForRest(game, slot);
}

void Demo::startRound(const Game& game) {
  if (game.sharedLevel() != level_) {
    level_ = game.sharedLevel();
    way_ = wayOf_ ? wayOf_(*level_) : std::nullopt;
    distance_.reset();
  }
  plan_.clear();
  search_.reset();
  last_.reset();
  waitedTicks_ = 0;
}

// On a level for several players, those of all clients begin the way again in the same ticks of the round, whenever
// they have joined.
bool Demo::isCommonStart(std::uint32_t tick) const {
  return way_ && level_->players > 1 && tick % (way_->size() + kTicksPerSecond) == 0;
}

// For a player who is not there.
bool Demo::waitsInVain(const Game& game) const {
  return restingTicks_ >= kMaxTicksOfRest && game.presentPlayers() < level_->players;
}

// A restart leads to the state with which the round of the recording began. It needs a tick in which it is not held.
Input Demo::beginWay(const Game& game, std::uint32_t slot) {
  if ((game.player(slot).held & Input::kRestart) != 0 || isCommonStart(tick_ + 1)) return {};
  Solution plan = *way_;
  for (std::vector<Input>& tick : plan) {
    if (slot < tick.size()) continue;
    tick.resize(slot + 1);
    tick[slot] = tick.front();
  }
  for (Input& first : plan.front()) {
    if (first.buttons != 0) first = pressing(first, Input::kRestart);
  }
  adopt(game, slot, plan);
  return plan_[step_++];
}

Input Demo::waitForRest(const Game& game, std::uint32_t slot) {
  if (restingTicks_ < kTicksOfRest) {
    search_.reset();
    return ++waitedTicks_ > kMaxTicksToRest ? restartPlayer() : Input{};
  }
  waitedTicks_ = 0;
  return search(game, slot);
}

WaySearch::Limits Demo::limitsOfSearch(std::uint32_t slot) {
  if (!distance_) distance_ = std::make_shared<GoalDistance>(*level_);
  WaySearch::Limits limits;
  limits.states = kMaxStates;
  limits.ticksLeft = [distance = distance_, slot](const Game& game) {
    const EntityState& entity = game.world().entities()[slot];
    const std::int32_t left = distance->from({entity.part, entity.position}, game.openDoors());
    const bool isReachable = left != GoalDistance::kUnreachable;
    return isReachable ? static_cast<std::uint32_t>(kHaste * (left / motion::kRunSpeed)) : kFar;
  };
  return limits;
}

Input Demo::search(const Game& game, std::uint32_t slot) {
  if (!search_) search_.emplace(game, slot, limitsOfSearch(slot));
  const bool goesOn = search_->work(effort_);
  const WaySearch::Target goal;
  if (!search_->found().contains(goal)) return goesOn ? Input{} : restartPlayer();
  Solution plan;
  for (const Input input : search_->inputsTo(goal)) {
    plan.emplace_back(game.slots(), Input{Input::kPresent});
    plan.back()[slot] = input;
  }
  adopt(game, slot, plan);
  return plan_[step_++];
}

void Demo::adopt(const Game& start, std::uint32_t slot, const Solution& plan) {
  search_.reset();
  step_ = 0;
  plan_.clear();
  expected_.clear();
  Game game = start;
  for (const std::vector<Input>& inputs : plan) {
    plan_.push_back(inputs[slot]);
    expected_.push_back(motionOf(game, slot));
    game.advance(inputs);
  }
}

Input Demo::restartPlayer() {
  search_.reset();
  waitedTicks_ = 0;
  return {Input::kRestart};
}

}  // namespace platon
