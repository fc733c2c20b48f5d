#include "levels/reach/reach.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace platon {
namespace {

constexpr double kMaxCells = 1.2e6;  // on all faces with all ups
constexpr double kSmallestCell = 2;  // level units

double reachCellSize(const UprightFaces& faces) {
  double area = 0;
  for (const UprightFace& face : faces.all()) {
    Vec low = face.polygon[0];
    Vec high = low;
    for (const Vec corner : face.polygon) {
      low = {std::min(low.x, corner.x), std::min(low.y, corner.y)};
      high = {std::max(high.x, corner.x), std::max(high.y, corner.y)};
    }
    area += (high.x - low.x) * (high.y - low.y);
  }
  return std::max(kSmallestCell, std::sqrt(area / kMaxCells));
}

}  // namespace

Reach::Reach(const Level& level, int maxCrossings, std::vector<ElementWord> without)
    : faces_(level),
      maxCrossings_(maxCrossings),
      without_(std::move(without)),
      start_(uprightOf(level.start, level.startAngle)) {
  const double cellSize = reachCellSize(faces_);
  for (std::uint32_t node = 0; node < faces_.all().size(); ++node) {
    grids_.push_back(std::make_unique<ReachGrid>(level, faces_, node, cellSize));
    reached_.emplace_back(grids_.back()->size(), kUnreached);
  }
  for (const Element& element : level.elements) hasHazard_ = hasHazard_ || sendsBack(element.kind);
  startsAtDoor_ = startsAtDoor(level);
  setDoors(level);
  begin(open_);
  addFall(0, 0, start_);
  launchPending();
  // Fewer doors are smaller numbers, so that all flights that open these doors are known.
  while (!resumed_.empty()) {
    const auto next = resumed_.extract(resumed_.begin());
    begin(next.key());
    resume(next.mapped());
    launchPending();
  }
}

bool Reach::startsAtDoor(const Level& level) const {
  constexpr double reach = kApothemInUnits + 2;  // within a tick after a restart, when nobody is fast
  const std::vector<ReachWall> walls = wallsNear(level, faces_, 0);
  return std::any_of(walls.begin(), walls.end(), [&](const ReachWall& wall) {
    return wall.kind == ReachWall::Kind::kDoor && distance(start_, wall.line) < reach;
  });
}

bool Reach::opensDoors(const Element& element) const {
  return platon::opensDoors(element.kind) && !isAmong(without_, element);
}

void Reach::setDoors(const Level& level) {
  std::uint32_t doors = 0;
  std::uint32_t openers = 0;
  for (const Element& element : level.elements) {
    if (isDoor(element.kind)) doors |= element.bit();
    if (opensDoors(element)) openers |= element.bit();
  }
  open_ = doors & openers;
  if (level.players > 1) return;
  for (int numbers = 0; open_ != 0 && numbers < kMaxNumbers; ++numbers) {
    openable_ |= open_ & -open_;
    open_ &= open_ - 1;
  }
}

std::optional<int> Reach::crossingsTo(std::uint32_t face, Point position, Angle up) const {
  const std::uint32_t node = faces_.find(face, up);
  if (node == faces_.all().size()) return std::nullopt;
  const std::size_t cell = grids_[node]->cellAt(uprightOf(position, up));
  if (cell == grids_[node]->size() || reached_[node][cell] == kUnreached) return std::nullopt;
  return reached_[node][cell];
}

void Reach::begin(std::uint32_t open) {
  respawned_[phase_.open] = std::move(phase_.respawned);
  phase_ = {};
  phase_.open = open;
  for (const auto& grid : grids_) {
    phase_.known.emplace_back(2 * grid->size());
    phase_.launched.emplace_back(kKinds * grid->size(), kUnreached);
  }
}

// Flights go on with more doors open. Who flies may then come to a hazard, which leads back to the start or to a
// checkpoint that was touched before. Who restarts shuts the doors of keys, but is in the start for a tick before.
void Reach::resume(const std::vector<Resumed>& resumed) {
  int first = maxCrossings_;
  for (const auto& [launch, visits] : resumed) {
    if (isTooFar(visits.front().crossings)) continue;
    first = std::min(first, visits.front().crossings);
    fly(ReachFlight(world(), launch, visits), launch);
  }
  if (hasHazard_ || startsAtDoor_) addFall(first, 0, start_);
  for (const auto& [open, respawned] : respawned_) {
    if ((open & ~phase_.open) != 0) continue;
    for (const auto& [where, crossings] : respawned) respawn(std::max(crossings, first), *where.first, where.second);
  }
}

// A player appears at the place, without a velocity.
void Reach::addFall(int crossings, std::uint32_t node, Vec place) {
  const std::size_t cell = grids_[node]->cellAt(place);
  for (const bool inOneway : {false, true}) {
    const ReachLaunch launch{node,
                             false,
                             inOneway,
                             FlightEnvelope::measured().runSpeed(),
                             grids_[node]->rectOf(cell).high.y,
                             {static_cast<std::uint32_t>(cell)}};
    fly(ReachFlight(world(), launch, crossings), launch);
  }
}

void Reach::launchPending() {
  while (!phase_.pending.empty() && !isTooFar(phase_.pending.begin()->first)) {
    auto first = phase_.pending.extract(phase_.pending.begin());
    for (auto& [node, starts] : first.mapped()) {
      // A flight with fewer crossings, or a faster one, may have come here since.
      std::erase_if(starts, [&, n = node](std::uint32_t start) {
        return phase_.launched[n][start] != first.key() || isOutdone(n, start, first.key());
      });
      if (!starts.empty()) launchRuns(first.key(), node, starts);
    }
  }
}

// Divides the cells into runs of neighbours of the same kind.
void Reach::launchRuns(int crossings, std::uint32_t node, Starts starts) {
  std::sort(starts.begin(), starts.end());
  const ReachGrid& grid = *grids_[node];
  const auto columns = static_cast<std::size_t>(grid.columns());
  Starts run;
  for (const std::uint32_t start : starts) {
    const std::size_t index = start % grid.size();
    const bool isNext = !run.empty() && start == run.back() + 1 && index % columns != 0;
    const auto isAlike = [&](const ReachGrid::Cell& cell, const ReachGrid::Cell& before) {
      return cell.grounded == before.grounded && cell.sloped == before.sloped;
    };
    if (!run.empty() && !(isNext && isAlike(grid[index], grid[index - 1]))) {
      launch(crossings, node, run);
      run.clear();
    }
    run.push_back(start);
  }
  if (!run.empty()) launch(crossings, node, run);
}

// A jump where the player may stand, else a fall.
void Reach::launch(int crossings, std::uint32_t node, const Starts& run) {
  const FlightEnvelope& envelope = FlightEnvelope::measured();
  const ReachGrid& grid = *grids_[node];
  const auto size = static_cast<std::uint32_t>(grid.size());
  const std::uint32_t kind = run.front() / size;
  ReachLaunch launch;
  launch.node = node;
  launch.inOneway = kind % 2 != 0;
  launch.rising = kind / 2 % 2 != 0;
  launch.speed = envelope.speedOf(static_cast<int>(kind / 4));
  for (const std::uint32_t start : run) launch.cells.push_back(start % size);
  const ReachGrid::Cell& first = grid[launch.cells.front()];
  launch.apex = grid.rectOf(launch.cells.front()).high.y;
  if (launch.rising) {
    double highest = -1e300;
    for (const std::uint32_t cell : launch.cells) highest = std::max(highest, grid[cell].highest);
    launch.apex = highest + envelope.jumpHeight() + envelope.pushGain(launch.speed) +
                  (first.sloped ? envelope.slopeGain(launch.speed) : 0);
  }
  fly(ReachFlight(world(), launch, crossings), launch);
}

// Where the flight opens doors, it goes on with these open, too.
void Reach::fly(ReachFlight flight, const ReachLaunch& launch) {
  std::map<std::pair<std::uint32_t, int>, std::vector<ReachVisit>> opened;  // by doors and crossings
  flight.run([&](const ReachVisit& visit) {
    this->visit(visit);
    for (std::uint32_t doors = openedBy(visit); doors != 0; doors &= doors - 1)
      opened[{doors & -doors, visit.crossings}].push_back(visit);
  });
  for (auto& [how, visits] : opened) resumed_[phase_.open | how.first].push_back({launch, std::move(visits)});
}

void Reach::visit(const ReachVisit& visit) {
  std::uint8_t& reached = reached_[visit.node][visit.cell];
  reached = std::min(reached, static_cast<std::uint8_t>(visit.crossings));
  const ReachGrid::Cell& cell = (*grids_[visit.node])[visit.cell];
  if (cell.atGoal) toGoal_ = std::min(toGoal_.value_or(visit.crossings), visit.crossings);
  for (const ReachWall& wall : grids_[visit.node]->touched(visit.cell)) {
    switch (traitsOf(wall.element->kind).effect) {
      case ElementEffect::kCheckpoint:
        if (hasHazard_ && !isAmong(without_, *wall.element)) respawn(visit.crossings, *wall.element, wall.node);
        break;
      case ElementEffect::kNone:
      case ElementEffect::kSendBack:  // to a checkpoint that was touched, or to the start
      case ElementEffect::kOpen:      // openedBy
      case ElementEffect::kUnlock:
        break;
    }
  }
  addStarts(visit, cell);
}

// A tick on the ground takes a pace from who jumps, but none from who slides or passes an end.
void Reach::addStarts(const ReachVisit& visit, const ReachGrid::Cell& cell) {
  const FlightEnvelope& envelope = FlightEnvelope::measured();
  const int jumping = std::max(envelope.paceOf(visit.speed) - 1, 0);
  const int falling = envelope.paceOf(cell.steep ? envelope.slidingSpeed(cell.flattest, visit.speed) : visit.speed);
  if (cell.grounded) addStart(visit, jumping, true);
  if (cell.slowed && (!visit.isBelow || cell.steep) && (!cell.grounded || falling > jumping))
    addStart(visit, falling, false);
}

void Reach::addStart(const ReachVisit& visit, int pace, bool rising) {
  const std::uint32_t kind = 4 * static_cast<std::uint32_t>(pace) + (rising ? 2 : 0) + (visit.inOneway ? 1 : 0);
  const std::uint32_t start = kind * static_cast<std::uint32_t>(grids_[visit.node]->size()) + visit.cell;
  std::uint8_t& launched = phase_.launched[visit.node][start];
  if (launched <= visit.crossings || isOutdone(visit.node, start, visit.crossings)) return;
  launched = static_cast<std::uint8_t>(visit.crossings);
  phase_.pending[visit.crossings][visit.node].push_back(start);
}

// Whether a faster start from this cell, with no more crossings, is known.
bool Reach::isOutdone(std::uint32_t node, std::uint32_t start, int crossings) const {
  const std::vector<std::uint8_t>& launched = phase_.launched[node];
  const std::size_t step = 4 * grids_[node]->size();
  for (std::size_t faster = start + step; faster < launched.size(); faster += step) {
    if (launched[faster] <= crossings) return true;
  }
  return false;
}

// A hazard brings the player back to its last checkpoint. It falls from rest there: an earlier visit to the place may
// have been faster and so have led less far.
void Reach::respawn(int crossings, const Element& checkpoint, std::uint32_t node) {
  const auto [known, isNew] = phase_.respawned.try_emplace({&checkpoint, node}, crossings);
  if (!isNew && known->second <= crossings) return;
  known->second = crossings;
  addFall(crossings, node, uprightOf(placeOf(checkpoint), faces_.all()[node].up));
}

// The doors that a player in this cell may open.
std::uint32_t Reach::openedBy(const ReachVisit& visit) const {
  std::uint32_t opened = 0;
  for (const ReachWall& wall : grids_[visit.node]->touched(visit.cell)) {
    if (opensDoors(*wall.element)) opened |= wall.element->bit();
  }
  return opened & openable_ & ~phase_.open;
}

}  // namespace platon
