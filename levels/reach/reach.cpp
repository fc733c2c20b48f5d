#include "levels/reach/reach.h"

#include <algorithm>
#include <cmath>

namespace platon {
namespace {

constexpr double kMaxCells = 1.2e6;  // on all faces with all ups
constexpr double kSmallestCell = 2;  // level units
constexpr int kNever = 1 << 20;

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

Reach::Reach(const Level& level, int maxCrossings)
    : faces_(level), maxCrossings_(maxCrossings), opened_(kMaxDoorNumbers, level.players > 1 ? 0 : kNever) {
  const double cellSize = reachCellSize(faces_);
  for (std::uint32_t node = 0; node < faces_.all().size(); ++node)
    grids_.push_back(std::make_unique<ReachGrid>(level, faces_, node, cellSize));
  for (const Element& element : level.elements) hasHazard_ = hasHazard_ || element.kind == ElementKind::kHazard;
  do {
    opensMore_ = false;
    search(level);
  } while (opensMore_);
}

std::optional<int> Reach::crossingsTo(std::uint32_t face, Point position, Angle up) const {
  const std::uint32_t node = faces_.find(face, up);
  if (node == faces_.all().size()) return std::nullopt;
  const std::size_t cell = grids_[node]->cellAt(uprightOf(position, up));
  if (cell == grids_[node]->size() || reached_[node][cell] == kUnreached) return std::nullopt;
  return reached_[node][cell];
}

void Reach::search(const Level& level) {
  clear();
  addFall(0, 0, uprightOf(level.start, level.startAngle));
  while (!pending_.empty() && (!toGoal_ || pending_.begin()->first < *toGoal_)) launchPending();
}

void Reach::clear() {
  toGoal_.reset();
  pending_.clear();
  reached_.clear();
  launched_.clear();
  known_.clear();
  for (const auto& grid : grids_) {
    reached_.emplace_back(grid->size(), kUnreached);
    known_.emplace_back(2 * grid->size());
    launched_.emplace_back(2 * grid->size(), kUnreached);
  }
}

// A player appears at the place, without a velocity.
void Reach::addFall(int crossings, std::uint32_t node, Vec place) {
  const std::size_t cell = grids_[node]->cellAt(place);
  for (const bool inOneway : {false, true}) {
    fly(crossings, {node,
                    false,
                    inOneway,
                    FlightEnvelope::measured().runSpeed(),
                    grids_[node]->rectOf(cell).high.y,
                    {static_cast<std::uint32_t>(cell)}});
  }
}

void Reach::launchPending() {
  auto first = pending_.extract(pending_.begin());
  for (auto& [node, starts] : first.mapped()) {
    // A flight with fewer crossings may have come here since.
    std::erase_if(starts, [&, n = node](std::uint32_t start) { return launched_[n][start] != first.key(); });
    if (!starts.empty()) launchRuns(first.key(), node, starts);
  }
}

// Divides the cells into runs of neighbours of the same kind.
void Reach::launchRuns(int crossings, std::uint32_t node, Starts starts) {
  std::sort(starts.begin(), starts.end(),
            [](std::uint32_t a, std::uint32_t b) { return std::pair(a & 1, a) < std::pair(b & 1, b); });
  const ReachGrid& grid = *grids_[node];
  const auto columns = static_cast<std::uint32_t>(grid.columns());
  Starts run;
  for (const std::uint32_t start : starts) {
    const ReachGrid::Cell& cell = grid[start / 2];
    const bool continues = !run.empty() && start == run.back() + 2 && (start / 2) % columns != 0 &&
                           cell.grounded == grid[run.back() / 2].grounded &&
                           cell.sloped == grid[run.back() / 2].sloped && cell.steep == grid[run.back() / 2].steep;
    if (!continues && !run.empty()) {
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
  const ReachGrid::Cell& kind = grid[run.front() / 2];
  ReachLaunch launch;
  launch.node = node;
  launch.inOneway = (run.front() & 1) != 0;
  launch.rising = kind.grounded;
  launch.speed = kind.steep ? envelope.slideSpeed() : envelope.runSpeed();
  launch.apex = grid.rectOf(run.front() / 2).high.y;
  for (const std::uint32_t start : run) launch.cells.push_back(start / 2);
  if (kind.grounded) {
    double highest = -1e300;
    for (const std::uint32_t cell : launch.cells) highest = std::max(highest, grid[cell].highest);
    launch.apex = highest + envelope.jumpHeight() + envelope.pushGain() + (kind.sloped ? envelope.slopeGain() : 0);
  }
  fly(crossings, launch);
}

void Reach::fly(int crossings, const ReachLaunch& launch) {
  const ReachFlight::World world{faces_, grids_, opened_, known_, maxCrossings_};
  ReachFlight(world, launch, crossings).run([this](const ReachVisit& visit) { this->visit(visit); });
}

void Reach::visit(const ReachVisit& visit) {
  std::uint8_t& reached = reached_[visit.node][visit.cell];
  reached = std::min(reached, static_cast<std::uint8_t>(visit.crossings));
  const ReachGrid::Cell& cell = (*grids_[visit.node])[visit.cell];
  if (cell.atGoal) toGoal_ = std::min(toGoal_.value_or(visit.crossings), visit.crossings);
  for (const ReachWall& wall : grids_[visit.node]->touched(visit.cell)) touch(visit, wall);
  if (!cell.grounded && (!cell.slowed || (visit.isBelow && !cell.steep))) return;
  const std::uint32_t start = visit.cell * 2 + (visit.inOneway ? 1 : 0);
  std::uint8_t& launched = launched_[visit.node][start];
  if (launched <= visit.crossings) return;
  launched = static_cast<std::uint8_t>(visit.crossings);
  pending_[visit.crossings][visit.node].push_back(start);
}

void Reach::touch(const ReachVisit& visit, const ReachWall& wall) {
  const Element& element = *wall.element;
  if (element.kind == ElementKind::kKey || element.kind == ElementKind::kPlate) {
    int& opened = opened_[element.number];
    opensMore_ = opensMore_ || visit.crossings < opened;
    opened = std::min(opened, visit.crossings);
  }
  if (element.kind != ElementKind::kCheckpoint || !hasHazard_) return;
  const UprightFace& face = faces_.all()[wall.node];
  const Vec place = uprightOf(placeOf(element), face.up);
  const std::size_t cell = grids_[wall.node]->cellAt(place);
  if (reached_[wall.node][cell] <= visit.crossings) return;
  reached_[wall.node][cell] = static_cast<std::uint8_t>(visit.crossings);
  addFall(visit.crossings, wall.node, place);
}

}  // namespace platon
