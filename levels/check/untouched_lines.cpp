#include "levels/check/untouched_lines.h"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "levels/reach/flight_envelope.h"
#include "levels/reach/reach_grid.h"
#include "levels/reach/upright_faces.h"
#include "platon/game/player.h"

namespace platon {
namespace {

constexpr double kCell = 6;  // level units
// Levels with more lines or larger faces are not made by hand, and are not searched.
constexpr std::size_t kMostLines = 3000;
constexpr std::int32_t kLargestFace = 2000;

std::size_t linesOf(const Level& level) {
  std::size_t lines = 0;
  for (const auto& face : level.segments) lines += face.size();
  return lines;
}

// The places that a player may reach, by the heights of its jumps alone.
class JumpHeights {
 public:
  explicit JumpHeights(const Level& level) : faces_(level) {
    for (std::uint32_t node = 0; node < faces_.all().size(); ++node) {
      grids_.emplace_back(level, faces_, node, kCell);
      apexes_.emplace_back(grids_.back().size(), kNever);
      fallen_.emplace_back(grids_.back().size());
    }
    const Vec start = uprightOf(level.start, level.startAngle);
    fall(0, grids_[0].cellAt(start));
    while (const auto place = take()) spread(*place);
  }

  bool touches(std::uint32_t face, const Segment& segment) const {
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

 private:
  struct Place {
    std::uint32_t node;
    std::size_t cell;
    bool rising;
  };
  static constexpr double kNever = -1e300;
  static constexpr int kMostHeight = 100;  // level units

  bool touches(std::uint32_t node, const Line& line) const {
    constexpr double reach = double{1} * kPlayerRadius / kSubunitsPerUnit + 0.05;
    const Vec margin{reach, reach};
    std::vector<std::size_t> cells;
    grids_[node].findOverlapped({Vec{std::min(line.a.x, line.b.x), std::min(line.a.y, line.b.y)} - margin,
                                 Vec{std::max(line.a.x, line.b.x), std::max(line.a.y, line.b.y)} + margin},
                                cells);
    return std::any_of(cells.begin(), cells.end(), [&](std::size_t cell) {
      return fallen_[node][cell] && distance(grids_[node].rectOf(cell), line) <= reach;
    });
  }

  void put(const Place& place, double height) {
    open_[static_cast<std::size_t>(std::clamp(height, 0.0, double{1} * kMostHeight))].push_back(place);
  }
  std::optional<Place> take() {
    for (auto places = open_.rbegin(); places != open_.rend(); ++places) {
      if (places->empty()) continue;
      const Place place = places->back();
      places->pop_back();
      return place;
    }
    return std::nullopt;
  }

  bool isOpen(std::uint32_t node, std::size_t cell) const {
    const ReachGrid& grid = grids_[node];
    return cell < grid.size() && grid[cell].inside && !grid[cell].blocked;
  }
  // A player falls at the cell; where it can stand, it jumps.
  void fall(std::uint32_t node, std::size_t cell) {
    if (!isOpen(node, cell) || fallen_[node][cell]) return;
    fallen_[node][cell] = true;
    put({node, cell, false}, kMostHeight);
    const ReachGrid::Cell& here = grids_[node][cell];
    const FlightEnvelope& envelope = FlightEnvelope::measured();
    if (here.grounded)
      rise(node, cell, here.highest + envelope.jumpHeight() + envelope.pushGain() + envelope.slopeGain());
  }
  void rise(std::uint32_t node, std::size_t cell, double apex) {
    constexpr double leastGain = 0.5;
    if (!isOpen(node, cell) || grids_[node].rectOf(cell).low.y > apex) return;
    fall(node, cell);
    // A way along edges may sink by a cell at each of them, and nobody rises more than from the ground.
    apex = std::min(apex, grids_[node].rectOf(cell).low.y + kMostHeight);
    if (apex < apexes_[node][cell] + leastGain) return;
    apexes_[node][cell] = apex;
    put({node, cell, true}, apex - grids_[node].rectOf(cell).low.y);
  }

  void spread(const Place& place) {
    const auto columns = static_cast<std::size_t>(grids_[place.node].columns());
    const std::size_t cell = place.cell;
    const auto go = [&](std::size_t to) {
      place.rising ? rise(place.node, to, apexes_[place.node][cell]) : fall(place.node, to);
    };
    if (cell % columns > 0) go(cell - 1);
    if (cell % columns + 1 < columns) go(cell + 1);
    if (place.rising) go(cell + columns);
    if (!place.rising && cell >= columns) go(cell - columns);
    cross(place);
  }

  void cross(const Place& place) {
    const UprightFace& face = faces_.all()[place.node];
    const Rect rect = grids_[place.node].rectOf(place.cell);
    for (std::size_t edge = 0; edge < face.polygon.size(); ++edge) {
      const Line line{face.polygon[edge], face.polygon[(edge + 1) % face.polygon.size()]};
      if (distance(rect, line) > 0.1) continue;
      const auto& behind = face.neighbours[edge];
      std::vector<std::size_t> cells;
      // Of the rows of cells behind the edge, only the nearest one, so that no way along the edge climbs from row to
      // row.
      const double y = rect.middle().y + behind.shift.y;
      grids_[behind.node].findOverlapped({{rect.low.x + behind.shift.x, y}, {rect.high.x + behind.shift.x, y}}, cells);
      for (const std::size_t next : cells)
        place.rising ? rise(behind.node, next, apexes_[place.node][place.cell] + behind.shift.y)
                     : fall(behind.node, next);
    }
  }

  UprightFaces faces_;
  std::vector<ReachGrid> grids_;
  std::vector<std::vector<double>> apexes_;               // of rises, by node and cell
  std::vector<std::vector<bool>> fallen_;                 // by node and cell
  std::array<std::vector<Place>, kMostHeight + 1> open_;  // by the height that is left to rise, the largest first
};

}  // namespace

void warnOfUntouchedLines(const Level& level, Diagnostics& diagnostics) {
  if (linesOf(level) > kMostLines || level.faceSize > kLargestFace) return;
  const JumpHeights heights(level);
  for (std::uint32_t face = 0; face < level.segments.size(); ++face) {
    for (std::size_t i = 0; i < level.segments[face].size(); ++i) {
      if (heights.touches(face, level.segments[face][i])) continue;
      diagnostics.warning(level.positions[face][i], "nobody can touch this line: remove it, or open a way to it");
    }
  }
}

}  // namespace platon
