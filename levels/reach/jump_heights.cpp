#include "levels/reach/jump_heights.h"

#include <algorithm>

#include "levels/reach/flight_envelope.h"
#include "platon/game/player.h"

namespace platon {
namespace {

constexpr double kCell = 6;                   // level units
constexpr double kMaxHeightCells = 4e6;       // on all faces with all ups
constexpr std::size_t kPlacesAtATime = 4096;  // between two questions whether to stop

constexpr double kLeastGain = 0.5;  // of a higher rise to the same cell, level units

// Larger cells for large faces, so that memory is bounded.
double heightCellSize(const UprightFaces& faces) {
  double area = 0;
  for (const UprightFace& face : faces.all()) {
    double reach = 0;
    for (const Vec corner : face.polygon) reach = std::max(reach, length(corner));
    area += 4 * reach * reach;
  }
  return std::max(kCell, std::sqrt(area / kMaxHeightCells));
}

}  // namespace

JumpHeights::JumpHeights(const Level& level, const Options& options)
    : faces_(level), options_(options), opened_(options.allDoorsOpen ? UINT32_MAX : 0) {
  const double cellSize = heightCellSize(faces_);
  for (std::uint32_t node = 0; node < faces_.all().size(); ++node) {
    if (stops()) return;
    grids_.emplace_back(level, faces_, node, cellSize);
    apexes_.emplace_back(grids_.back().size(), kNever);
    dips_.emplace_back(grids_.back().size(), kNever);
    fallen_.emplace_back(grids_.back().size());
  }
  measure();
  for (const Element& element : level.elements) hasHazard_ = hasHazard_ || sendsBack(element.kind);
  search(level);
}

// Who jumps may have slid down the flattest of the steep segments, and been on the ground for a tick since.
void JumpHeights::measure() {
  const FlightEnvelope& envelope = FlightEnvelope::measured();
  double fastest = envelope.runSpeed();
  for (const ReachGrid& grid : grids_) {
    for (std::size_t cell = 0; cell < grid.size(); ++cell)
      fastest = std::max(fastest, envelope.slidingSpeed(grid[cell].flattest, fastest));
  }
  const double speed = envelope.speedOf(std::max(envelope.paceOf(fastest) - 1, 0));
  level_ = envelope.jumpHeight() + envelope.pushGain(speed);
  sloped_ = level_ + envelope.slopeGain(speed);
  depth_ = sloped_ + envelope.lateDepth(speed);
}

// Begins anew when a door has opened: who could not pass it before may pass it now.
void JumpHeights::search(const Level& level) {
  std::uint32_t before = 0;
  do {
    before = opened_;
    for (std::uint32_t node = 0; node < grids_.size(); ++node) {
      apexes_[node].assign(grids_[node].size(), kNever);
      dips_[node].assign(grids_[node].size(), kNever);
      fallen_[node].assign(grids_[node].size(), false);
    }
    fall(0, grids_[0].cellAt(uprightOf(level.start, level.startAngle)));
    std::size_t count = 0;
    while (const auto place = take()) {
      if (++count % kPlacesAtATime == 0 && stops()) return;
      spread(*place);
    }
  } while (opened_ != before);
}

bool JumpHeights::stops() {
  stopped_ = stopped_ || (options_.stop && options_.stop());
  return stopped_;
}

bool JumpHeights::reaches(std::uint32_t face, Point position) const {
  for (std::uint32_t node = 0; node < grids_.size(); ++node) {
    const UprightFace& upright = faces_.all()[node];
    if (upright.face != face) continue;
    const std::size_t cell = grids_[node].cellAt(uprightOf(position, upright.up));
    if (cell < grids_[node].size() && fallen_[node][cell]) return true;
  }
  return false;
}

bool JumpHeights::touches(std::uint32_t face, const Segment& segment) const {
  for (std::uint32_t node = 0; node < grids_.size(); ++node) {
    const UprightFace& upright = faces_.all()[node];
    if (upright.face != face) continue;
    const Line line{uprightOf(segment.a, upright.up), uprightOf(segment.b, upright.up)};
    if (touches(node, line)) return true;
    for (const auto& behind : upright.neighbours) {
      if (touches(behind.node, {line.a + behind.shift, line.b + behind.shift})) return true;
    }
  }
  return false;
}

bool JumpHeights::touches(std::uint32_t node, const Line& line) const {
  constexpr double reach = double{1} * kPlayerRadius / kSubunitsPerUnit + 0.05;
  std::vector<std::size_t> cells;
  grids_[node].findOverlapped(boundsOf(line, {reach, reach}), cells);
  return std::any_of(cells.begin(), cells.end(), [&](std::size_t cell) {
    return fallen_[node][cell] && distance(grids_[node].rectOf(cell), line) <= reach;
  });
}

void JumpHeights::put(const Place& place, double height) {
  open_[static_cast<std::size_t>(std::clamp(height, 0.0, double{1} * kMaxHeight))].push_back(place);
}

std::optional<JumpHeights::Place> JumpHeights::take() {
  for (auto places = open_.rbegin(); places != open_.rend(); ++places) {
    if (places->empty()) continue;
    const Place place = places->back();
    places->pop_back();
    return place;
  }
  return std::nullopt;
}

bool JumpHeights::isOpen(std::uint32_t node, std::size_t cell) const {
  const ReachGrid& grid = grids_[node];
  return cell < grid.size() && grid[cell].inside && !grid[cell].blocked && (grid[cell].doors & ~opened_) == 0;
}

// A player falls at the cell; where it can stand, it jumps.
void JumpHeights::fall(std::uint32_t node, std::size_t cell) {
  if (!isOpen(node, cell) || fallen_[node][cell]) return;
  fallen_[node][cell] = true;
  put({node, cell, Motion::kFall}, kMaxHeight);
  const ReachGrid::Cell& here = grids_[node][cell];
  reachesGoal_ = reachesGoal_ || here.atGoal;
  for (const ReachWall& wall : grids_[node].touched(cell)) touch(wall);
  if (here.grounded) dip(node, cell, here.highest + (here.sloped ? sloped_ : level_));
}

// A key or a plate opens its doors; from a checkpoint, a hazard brings a player to its middle.
void JumpHeights::touch(const ReachWall& wall) {
  const Element& element = *wall.element;
  if (isAmong(options_.without, element)) return;
  switch (traitsOf(element.kind).effect) {
    case ElementEffect::kOpen:
    case ElementEffect::kUnlock:
      opened_ |= element.bit();
      return;
    case ElementEffect::kCheckpoint:
      if (hasHazard_)
        fall(wall.node, grids_[wall.node].cellAt(uprightOf(placeOf(element), faces_.all()[wall.node].up)));
      return;
    case ElementEffect::kNone:
    case ElementEffect::kSendBack:  // to a checkpoint that was touched, or to the start
      return;
  }
}

void JumpHeights::rise(std::uint32_t node, std::size_t cell, double apex) {
  if (!isOpen(node, cell) || grids_[node].rectOf(cell).low.y > apex) return;
  fall(node, cell);
  // A way along edges may sink by a cell at each of them, and nobody rises more than from the ground.
  apex = std::min(apex, grids_[node].rectOf(cell).high.y + kMaxHeight);
  if (apex < apexes_[node][cell] + kLeastGain) return;
  apexes_[node][cell] = apex;
  put({node, cell, Motion::kRise}, apex - grids_[node].rectOf(cell).low.y);
}

// Who leaves the ground may jump a little later, and lower. `apex` follows from the ground.
void JumpHeights::dip(std::uint32_t node, std::size_t cell, double apex) {
  if (!isOpen(node, cell) || grids_[node].rectOf(cell).high.y < apex - depth_) return;
  rise(node, cell, apex);
  if (apex < dips_[node][cell] + kLeastGain) return;
  dips_[node][cell] = apex;
  put({node, cell, Motion::kDip}, kMaxHeight);
}

// Goes on in a cell of a node in whose frame y is larger by `risen`.
void JumpHeights::go(const Place& from, std::uint32_t node, std::size_t cell, double risen) {
  if (from.motion == Motion::kFall) fall(node, cell);
  if (from.motion == Motion::kRise) rise(node, cell, apexes_[from.node][from.cell] + risen);
  if (from.motion == Motion::kDip) dip(node, cell, dips_[from.node][from.cell] + risen);
}

void JumpHeights::spread(const Place& place) {
  const auto columns = static_cast<std::size_t>(grids_[place.node].columns());
  const std::size_t cell = place.cell;
  const bool rises = place.motion == Motion::kRise;
  if (cell % columns > 0) go(place, place.node, cell - 1, 0);
  if (cell % columns + 1 < columns) go(place, place.node, cell + 1, 0);
  if (rises) go(place, place.node, cell + columns, 0);
  if (!rises && cell >= columns) go(place, place.node, cell - columns, 0);
  cross(place);
}

void JumpHeights::cross(const Place& place) {
  const UprightFace& face = faces_.all()[place.node];
  const Rect rect = grids_[place.node].rectOf(place.cell);
  for (std::size_t edge = 0; edge < face.polygon.size(); ++edge) {
    const Line line{face.polygon[edge], face.polygon[(edge + 1) % face.polygon.size()]};
    if (distance(rect, line) > 0.1) continue;
    const auto& behind = face.neighbours[edge];
    const ReachGrid& grid = grids_[behind.node];
    std::vector<std::size_t> cells;
    grid.findOverlapped({rect.low + behind.shift, rect.high + behind.shift}, cells);
    const double y = rect.middle().y + behind.shift.y;
    for (const std::size_t next : cells) {
      // Of the rows of cells behind the edge, only the nearest one, so that no way along the edge climbs from row to
      // row; another one where the nearest is blocked.
      const std::size_t nearest = grid.cellAt({grid.rectOf(next).middle().x, y});
      if (next != nearest && isOpen(behind.node, nearest)) continue;
      go(place, behind.node, next, behind.shift.y);
    }
  }
}

}  // namespace platon
