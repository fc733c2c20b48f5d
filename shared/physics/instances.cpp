#include "shared/physics/instances.h"

#include <algorithm>
#include <array>

#include "platon/exact/integer.h"
#include "shared/exact/lattice.h"
#include "shared/physics/collider.h"

namespace platon {
namespace {

// Candidate offsets from the lattice point nearest to the exact position, which is at most sqrt(1/2) from it. Contains
// all lattice points within kMaxError of the exact position.
constexpr auto kOffsets = latticeDisc<Instances::kMaxError + 1>();

constexpr std::int64_t kSquaredOne = PrecisePoint::kOne * PrecisePoint::kOne;
constexpr std::int64_t kMaxSquaredError = Instances::kMaxError * Instances::kMaxError * kSquaredOne;
// Smaller errors are not corrected: the nearest lattice point can be half the diagonal of a cell away.
constexpr std::int64_t kMinSquaredDrift = kSquaredOne / 2;

}  // namespace

void Instances::load(const Geometry& geometry, ShapeCache& shapes, const Convex& base, const EntityState& state,
                     std::span<const InstanceState> further) {
  nextId_ = state.nextId;
  crossings_ = state.crossings;
  if (geometry_ == &geometry && matches(state, further)) return;
  geometry_ = &geometry;
  shapes_ = &shapes;
  base_ = &base;
  shapeIndex_ = state.shape;
  hasRehomed_ = false;
  placements_.clear();
  loadHome(state);
  for (const InstanceState& instance : further) loadFurther(instance);
  for (std::size_t i = 0; i < further.size(); ++i) {
    if (further[i].parent != InstanceState::kNoParent) linkParent(i + 1, further[i].parent);
  }
}

// Fast path of `load`: whether the placements already hold this state, which is usual. Not valid after a rehome: when
// several warps share a segment, loading may choose another reverse warp than the rehome did.
bool Instances::matches(const EntityState& state, std::span<const InstanceState> further) const {
  if (hasRehomed_ || placements_.size() != further.size() + 1 || shapeIndex_ != state.shape) return false;
  if (home().part->id != state.part || home().position != state.position || home().angle != state.angle ||
      home().id != state.id || home().fresh != (state.fresh != 0))
    return false;
  for (std::size_t i = 0; i < further.size(); ++i) {
    if (stateOf(placements_[i + 1]) != further[i]) return false;
  }
  return true;
}

void Instances::loadHome(const EntityState& state) {
  Placement& home = placements_.emplace_back();
  home.part = geometry_->find(state.part);
  home.angle = state.angle;
  home.shape = shapes_->turned(shapeIndex_, *base_, state.angle);
  home.fromHome = home.toHome = Rotation::none();
  home.position = home.homeAnchor = home.anchor = state.position;
  home.id = state.id;
  home.fresh = state.fresh != 0;
}

void Instances::loadFurther(const InstanceState& instance) {
  Placement placement;
  placement.part = geometry_->find(instance.part);
  placement.angle = instance.angle;
  placement.shape = shapes_->turned(shapeIndex_, *base_, instance.angle);
  updateRotations(placement);
  placement.homeAnchor = instance.homeAnchor;
  placement.anchor = instance.anchor;
  placement.position = placement.at(home().position);
  placement.warp = instance.warp;
  placement.id = instance.id;
  placement.fresh = instance.fresh != 0;
  placement.region = placements_.size();
  placements_.push_back(placement);
}

void Instances::updateRotations(Placement& placement) const {
  placement.fromHome = rotationOf(placement.angle - home().angle);
  placement.toHome = rotationOf(home().angle - placement.angle);
}

void Instances::linkParent(std::size_t index, std::uint16_t parentId) {
  Placement& placement = placements_[index];
  const auto parent = std::find_if(placements_.begin(), placements_.end(),
                                   [&](const Placement& other) { return other.id == parentId; });
  placement.parent = static_cast<std::size_t>(parent - placements_.begin());
  const MapGeometry& part = *placements_[placement.parent].part;
  placement.reverseWarp = *geometry_->reverseWarp(part.id, part.warps[placement.warp]);
}

void Instances::storeHome(EntityState& state) const {
  state.part = home().part->id;
  state.position = home().position;
  state.angle = home().angle;
  state.id = home().id;
  state.nextId = nextId_;
  state.crossings = crossings_;
  state.fresh = home().fresh;
}

void Instances::store(EntityState& state, std::vector<InstanceState>& further) const {
  storeHome(state);
  state.instances = static_cast<std::uint16_t>(placements_.size() - 1);
  for (std::size_t i = 1; i < placements_.size(); ++i) further.push_back(stateOf(placements_[i]));
}

InstanceState Instances::stateOf(const Placement& placement) const {
  InstanceState instance;
  instance.part = placement.part->id;
  instance.angle = placement.angle;
  instance.homeAnchor = placement.homeAnchor;
  instance.anchor = placement.anchor;
  instance.id = placement.id;
  if (placement.parent != Placement::kNone) instance.parent = placements_[placement.parent].id;
  instance.warp = placement.warp;
  instance.fresh = placement.fresh;
  return instance;
}

void Instances::appendViews(std::vector<InstanceView>& out) const {
  for (const Placement& placement : placements_) {
    InstanceView view{.id = placement.id,
                      .part = placement.part->id,
                      .position = placement.position,
                      .angle = placement.angle,
                      .home = &placement == &home()};
    view.hasParent = placement.parent != Placement::kNone;
    if (view.hasParent) {
      view.parent = placements_[placement.parent].id;
      view.warp = placement.warp;
    }
    out.push_back(view);
  }
}

bool Instances::hasInstanceBehind(std::size_t index, std::uint16_t warp) const {
  const Placement& placement = placements_[index];
  if (placement.parent != Placement::kNone && placement.reverseWarp == warp) return true;
  return std::any_of(placements_.begin(), placements_.end(),
                     [&](const Placement& child) { return child.parent == index && child.warp == warp; });
}

bool Instances::isAtInstanceLimit(std::size_t parent) const {
  int depth = 1;
  for (; placements_[parent].parent != Placement::kNone; parent = placements_[parent].parent) ++depth;
  return placements_.size() == kMax || depth > kMaxDepth;
}

bool Instances::insert(std::size_t parentIndex, std::uint16_t warpIndex, Collider& collider) {
  const Placement& parent = placements_[parentIndex];
  const Warp& warp = parent.part->warps[warpIndex];
  const auto reverseWarp = geometry_->reverseWarp(parent.part->id, warp);
  if (!reverseWarp) return false;
  Placement child;
  child.part = geometry_->find(warp.target);
  child.angle = parent.angle + warp.turn;
  child.shape = shapes_->turned(shapeIndex_, *base_, child.angle);
  if (child.shape == nullptr) return false;
  updateRotations(child);
  child.parent = parentIndex;
  child.warp = warpIndex;
  child.reverseWarp = *reverseWarp;
  child.fresh = true;
  child.region = unusedRegion();
  collider.provideRegion(child.region);
  std::uint16_t nextId = nextId_;
  child.id = allocateId(nextId, [&](std::uint16_t id) {
    return std::any_of(placements_.begin(), placements_.end(), [&](const Placement& other) { return other.id == id; });
  });
  const auto position =
      nearestFree(child, Arrival::kAppears, warp.map(exactPosition(parentIndex)), kMaxSquaredError + 1, collider);
  if (!position) return false;
  nextId_ = nextId;
  child.position = child.anchor = *position;
  child.homeAnchor = home().position;
  placements_.push_back(child);
  return true;
}

void Instances::reuseIds(std::uint16_t first) {
  if (std::none_of(placements_.begin(), placements_.end(), [](const Placement& placement) { return placement.fresh; }))
    nextId_ = first;
}

void Instances::moveHomeTo(Point position) {
  for (std::size_t i = 1; i < placements_.size(); ++i) placements_[i].position = placements_[i].at(position);
  home().position = home().anchor = home().homeAnchor = position;
}

void Instances::rotateShapes(std::int32_t centidegrees) {
  for (std::size_t i = 0; i < placements_.size(); ++i) {
    placements_[i].shape = rotatedShape(i, centidegrees);
    placements_[i].angle = placements_[i].angle + Angle(centidegrees);
  }
}

std::optional<Box> Instances::rotationBounds(std::size_t index, std::int32_t centidegrees) {
  const Convex* after = rotatedShape(index, centidegrees);
  if (after == nullptr) return std::nullopt;
  const Placement& placement = placements_[index];
  const Box both = placement.shape->bounds().joined(after->bounds());
  return Box{placement.position + both.low, placement.position + both.high};
}

const Convex* Instances::rotationHull(std::size_t index, std::int32_t centidegrees) {
  return shapes_->rotationHull(shapeIndex_, *base_, placements_[index].angle, centidegrees);
}

const Convex* Instances::rotatedShape(std::size_t index, std::int32_t centidegrees) {
  return shapes_->turned(shapeIndex_, *base_, placements_[index].angle + Angle(centidegrees));
}

std::optional<Angle> Instances::rehomeTo(std::size_t next, PrecisePoint& remainder) {
  const Angle before = home().angle;
  const Warp& warp = home().part->warps[placements_[next].warp];
  const PrecisePoint there = warp.map(precise(home().position) + remainder);
  makeHome(next);
  for (std::size_t i = 1; i < placements_.size(); ++i) {
    if (isWithinError(i)) continue;
    makeHome(next);  // as it was
    return std::nullopt;
  }
  anchorAll();
  ++crossings_;
  hasRehomed_ = true;
  remainder = there - precise(home().position);
  return home().angle - before;
}

// The child of the home instance that must become home: the one whose warp the centre has crossed, preferably on the
// branch to the part that contains the centre. Near a corner the centre can be beyond two warp segments although it has
// crossed only one. kNone when the home part contains the centre, or when by rounding no part does.
std::size_t Instances::nextHome() const {
  if (containsCentre(0)) return Placement::kNone;
  for (std::size_t i = 1; i < placements_.size(); ++i) {
    const std::size_t child = childOfHome(i);
    if (child != Placement::kNone && isBeyondWarp(child) && containsCentre(i)) return child;
  }
  for (std::size_t i = 1; i < placements_.size(); ++i) {
    if (placements_[i].parent == 0 && isBeyondWarp(i)) return i;
  }
  return Placement::kNone;
}

// The ancestor of placement `index`, or the placement itself, that is a child of the home instance. kNone if none is.
std::size_t Instances::childOfHome(std::size_t index) const {
  while (placements_[index].parent != 0) {
    index = placements_[index].parent;
    if (index == Placement::kNone) return index;
  }
  return index;
}

bool Instances::isBeyondWarp(std::size_t index) const {
  const Placement& child = placements_[index];
  const Segment& out = home().part->warps[child.warp].from;
  if (cross(out.b - out.a, centreOf(home()) - out.a) >= 0) return false;
  const Segment& in = child.part->warps[child.reverseWarp].from;
  return cross(in.b - in.a, centreOf(child) - in.a) >= 0;
}

bool Instances::isInside(const MapGeometry& part, Point centre) {
  return std::all_of(part.warps.begin(), part.warps.end(),
                     [&](const Warp& warp) { return cross(warp.from.b - warp.from.a, centre - warp.from.a) >= 0; });
}

// Tries it, and takes it back.
bool Instances::canRehomeAt(Point home, Collider& collider) {
  std::array<Placement, kMax> before;
  std::copy(placements_.begin(), placements_.end(), before.begin());
  const std::uint32_t crossings = crossings_;
  const bool hasRehomed = hasRehomed_;
  moveHomeTo(home);
  PrecisePoint remainder;
  while (rehome(remainder, collider, [] {})) {
  }
  const bool can = nextHome() == Placement::kNone;
  std::copy_n(before.begin(), placements_.size(), placements_.begin());
  crossings_ = crossings;
  hasRehomed_ = hasRehomed;
  return can;
}

void Instances::makeHome(std::size_t nextHome) {
  Placement& oldHome = placements_.front();
  Placement& newHome = placements_[nextHome];
  oldHome.parent = nextHome;
  oldHome.warp = newHome.reverseWarp;
  oldHome.reverseWarp = newHome.warp;
  newHome.parent = Placement::kNone;
  std::swap(oldHome, newHome);
  for (Placement& placement : placements_) {
    if (placement.parent == 0) {
      placement.parent = nextHome;
    } else if (placement.parent == nextHome) {
      placement.parent = 0;
    }
  }
  for (Placement& placement : placements_) updateRotations(placement);
}

void Instances::anchorAll() {
  for (Placement& placement : placements_) {
    placement.homeAnchor = home().position;
    placement.anchor = placement.position;
  }
}

// Every rehome inverts a rounded placement. Without this correction the rounding errors of an entity that crosses an
// edge back and forth would accumulate.
bool Instances::correctDrift(Collider& collider) {
  bool any = false;
  for (std::size_t i = 1; i < placements_.size(); ++i) {
    Placement& placement = placements_[i];
    if (placement.parent == Placement::kNone) continue;
    const PrecisePoint target = exactPosition(i);
    const std::int64_t error = squaredError(target, placement.position);
    if (error <= kMinSquaredDrift) continue;
    const auto better = nearestFree(placement, Arrival::kMoves, target, error, collider);
    if (!better || *better == placement.position) continue;
    placement.position = placement.anchor = *better;
    placement.homeAnchor = home().position;
    any = true;
  }
  return any;
}

bool Instances::isWithinError(std::size_t index) const {
  return placements_[index].parent == Placement::kNone ||
         squaredError(exactPosition(index), placements_[index].position) <= kMaxSquaredError;
}

// The work of dropUnreached where there are further instances.
bool Instances::dropOthers(std::int32_t margin, Collider& collider) {
  std::array<bool, kMax> kept{};
  for (std::size_t i = 0; i < placements_.size(); ++i) kept[i] = isReached(i, margin, collider);
  const auto isConnected = [&](std::size_t index) {  // it and all its ancestors are kept
    while (index != Placement::kNone && kept[index]) index = placements_[index].parent;
    return index == Placement::kNone;
  };
  std::array<std::size_t, kMax> places{};  // those that stay, by their index
  std::size_t left = 0;
  for (std::size_t i = 0; i < placements_.size(); ++i) places[i] = isConnected(i) ? left++ : Placement::kNone;
  if (left == placements_.size()) return false;
  for (std::size_t i = 0; i < placements_.size(); ++i) {
    if (places[i] == Placement::kNone) continue;
    Placement& moved = placements_[places[i]];
    moved = placements_[i];
    if (moved.parent != Placement::kNone) moved.parent = places[moved.parent];
  }
  placements_.resize(left);
  return true;
}

bool Instances::isReached(std::size_t index, std::int32_t margin, Collider& collider) const {
  const Placement& child = placements_[index];
  if (child.parent == Placement::kNone) return true;
  const Placement& parent = placements_[child.parent];
  return collider.clip(parent, {parent.position, parent.position, margin}, parent.part->segmentOfWarp(child.warp))
      .has_value();
}

std::int64_t Instances::squaredError(PrecisePoint ideal, Point point) {
  constexpr std::int64_t limit = 16 * PrecisePoint::kOne;  // clamped so that the square fits 64 bits
  const PrecisePoint wide = precise(point);
  const std::int64_t x = std::clamp(wide.x - ideal.x, -limit, limit);
  const std::int64_t y = std::clamp(wide.y - ideal.y, -limit, limit);
  return x * x + y * y;
}

// The exact position of placement `index`: the position of its root mapped through the chain of warps.
PrecisePoint Instances::exactPosition(std::size_t index) const {
  const Placement& placement = placements_[index];
  if (placement.parent == Placement::kNone) return precise(placement.position);
  return placements_[placement.parent].part->warps[placement.warp].map(exactPosition(placement.parent));
}

PrecisePoint Instances::idealOfFurther(std::size_t index, PrecisePoint home) const {
  const Placement& placement = placements_[index];
  if (placement.parent != Placement::kNone)
    return placements_[placement.parent].part->warps[placement.warp].map(idealOf(placement.parent, home));
  return precise(placement.anchor) + rotated(home - precise(placement.homeAnchor), placement.fromHome);
}

// The lattice point nearest to `ideal`, with a squared error below `closerThan`, to which the placement may move, or
// where it may appear. Nothing when none is free.
std::optional<Point> Instances::nearestFree(Placement placement, Arrival arrival, PrecisePoint ideal,
                                            std::int64_t closerThan, Collider& collider) {
  const Point nearest = rounded(ideal);
  for (const Point offset : kOffsets) {
    const Point candidate = nearest + offset;
    if (squaredError(ideal, candidate) >= closerThan || !isCoordinate(candidate.x) || !isCoordinate(candidate.y))
      continue;
    if (arrival == Arrival::kAppears) placement.position = candidate;  // what the rules are asked about
    if (collider.isFree(placement, placement.position, candidate)) return candidate;
  }
  return std::nullopt;
}

std::size_t Instances::unusedRegion() const {
  std::size_t region = 0;
  const auto isUsed = [&](const Placement& placement) { return placement.region == region; };
  while (std::any_of(placements_.begin(), placements_.end(), isUsed)) ++region;
  return region;
}

}  // namespace platon
