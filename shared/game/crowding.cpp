#include "shared/game/crowding.h"

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

#include "platon/exact/integer.h"
#include "platon/game/level.h"
#include "shared/exact/square_root.h"

namespace platon {
namespace {

constexpr std::int32_t kTile = 8 * Crowding::kPlace;
// A segment farther than this from an edge is out of the reach of every place behind the edge: half a diagonal of the
// square that a place reaches is 57 units.
constexpr std::int32_t kBand = 64 * kSubunitsPerUnit;
// Edges that a straight line can cross at a corner: it turns by less than 180° round it, and a triangle has 60° there,
// a square or a pentagon at least 90°.
int maxEdgesCrossed(const MapGeometry& face) { return face.warps.size() == 3 ? 3 : 2; }

constexpr std::size_t kMost = kMaxSegmentsInReach;

// The points less than kBand inside an edge, or outside it.
class Band {
 public:
  explicit Band(const Segment& edge)
      : edge_(edge), limit_((static_cast<std::int64_t>(squareRootFloor(squaredLength(edge.b - edge.a))) + 1) * kBand) {}

  bool touches(const Segment& segment) const {
    const Point along = edge_.b - edge_.a;
    return std::min(cross(along, segment.a - edge_.a), cross(along, segment.b - edge_.a)) < limit_;
  }

 private:
  Segment edge_;
  std::int64_t limit_;
};

Segment mapBack(const Warp& warp, const Segment& segment) {
  return {rounded(warp.mapBack(precise(segment.a))), rounded(warp.mapBack(precise(segment.b)))};
}

bool isOutside(const MapGeometry& face, const Box& box) {
  const std::array corners = {box.low, Point(box.high.x, box.low.y), box.high, Point(box.low.x, box.high.y)};
  return std::any_of(face.warps.begin(), face.warps.end(), [&](const Warp& warp) {
    const Point along = warp.from.b - warp.from.a;
    return std::all_of(corners.begin(), corners.end(),
                       [&](Point corner) { return cross(along, corner - warp.from.a) < 0; });
  });
}

Box boundsOf(const MapGeometry& face) {
  Box box = boundsOf(face.warps[0].from);
  for (const Warp& warp : face.warps) {
    const Box edge = boundsOf(warp.from);
    box = {{std::min(box.low.x, edge.low.x), std::min(box.low.y, edge.low.y)},
           {std::max(box.high.x, edge.high.x), std::max(box.high.y, edge.high.y)}};
  }
  return box;
}

}  // namespace

// The search of one face. Counts the segments that touch each tile with its surroundings; divides only tiles with too
// many, until it is left with places.
class Crowding::Search {
 public:
  Search(const MapGeometry& face, const List& list)
      : face_(face),
        list_(list),
        bounds_(boundsOf(face)),
        columns_(tilesBetween(bounds_.low.x, bounds_.high.x)),
        rows_(tilesBetween(bounds_.low.y, bounds_.high.y)) {}

  std::optional<CrowdedPlace> first() {
    countSegments();
    collectCrowdedTiles();
    for (std::size_t i = 0; i < crowded_.size(); ++i) {
      if (auto place = divide(boxOf(crowded_[i]), lists_[i])) return place;
    }
    return std::nullopt;
  }

  // Of the tiles.
  std::size_t most() {
    countSegments();
    return *std::max_element(counts_.begin(), counts_.end());
  }

 private:
  static std::int64_t tilesBetween(std::int32_t low, std::int32_t high) { return (high - low) / kTile + 1; }

  // The range of tiles along one axis that a span touches with their surroundings. `origin`: where the first one
  // begins.
  static std::pair<std::int64_t, std::int64_t> tilesNear(std::int64_t low, std::int64_t high, std::int32_t origin,
                                                         std::int64_t count) {
    const std::int64_t first = divideCeiling<std::int64_t>(low - kReach - origin, kTile) - 1;
    const std::int64_t last = divideFloor<std::int64_t>(high + kReach - origin, kTile);
    return {std::max<std::int64_t>(first, 0), std::min(last, count - 1)};
  }

  // The x range of the part of a segment with y in [low, high], rounded outwards.
  static std::pair<std::int64_t, std::int64_t> runOf(Point a, Point b, std::int64_t low, std::int64_t high) {
    if (a.y == b.y) return std::minmax({std::int64_t{a.x}, std::int64_t{b.x}});
    const std::int64_t width = std::int64_t{b.x} - a.x;
    const std::int64_t height = std::int64_t{b.y} - a.y;
    const auto [first, last] = std::minmax({width * (low - a.y), width * (high - a.y)});
    return {a.x + divideFloor(first, height), a.x + divideCeiling(last, height)};
  }

  template <class Visit>
  void forEachTile(const Segment& segment, Visit&& visit) const {
    const auto [a, b] = segment.a.y <= segment.b.y ? segment : Segment{segment.b, segment.a};
    const auto [firstRow, lastRow] = tilesNear(a.y, b.y, bounds_.low.y, rows_);
    for (std::int64_t row = firstRow; row <= lastRow; ++row) {
      const std::int64_t bottom = bounds_.low.y + row * kTile;
      const auto [left, right] = runOf(a, b, std::max<std::int64_t>(a.y, bottom - kReach),
                                       std::min<std::int64_t>(b.y, bottom + kTile + kReach));
      const auto [firstColumn, lastColumn] = tilesNear(left, right, bounds_.low.x, columns_);
      for (std::int64_t column = firstColumn; column <= lastColumn; ++column) {
        visit(static_cast<std::size_t>(row * columns_ + column));
      }
    }
  }

  void countSegments() {
    counts_.assign(static_cast<std::size_t>(columns_ * rows_), 0);
    for (const Near& near : list_) forEachTile(near.segment, [this](std::size_t tile) { ++counts_[tile]; });
  }

  // From here on, counts_ has for a crowded tile one more than its index in crowded_, and 0 for the others.
  void collectCrowdedTiles() {
    for (std::size_t tile = 0; tile < counts_.size(); ++tile) {
      if (counts_[tile] > kMost) crowded_.push_back(tile);
      counts_[tile] = counts_[tile] > kMost ? static_cast<std::uint32_t>(crowded_.size()) : 0;
    }
    lists_.resize(crowded_.size());
    for (std::uint32_t i = 0; i < list_.size() && !crowded_.empty(); ++i) {
      forEachTile(list_[i].segment, [&](std::size_t tile) {
        if (counts_[tile] != 0) lists_[counts_[tile] - 1].push_back(i);
      });
    }
  }

  Box boxOf(std::size_t tile) const {
    const auto index = static_cast<std::int64_t>(tile);
    const Point low = bounds_.low + Point(static_cast<std::int32_t>(index % columns_ * kTile),
                                          static_cast<std::int32_t>(index / columns_ * kTile));
    return {low, low + Point(kTile, kTile)};
  }

  std::optional<CrowdedPlace> divide(const Box& box, const std::vector<std::uint32_t>& segments) const {
    if (segments.size() <= kMost || isOutside(face_, box)) return std::nullopt;
    const std::int32_t half = (box.high.x - box.low.x) / 2;
    if (2 * half == kPlace) return placeOf(box, segments);
    std::vector<std::uint32_t> within;
    for (const Point corner : {Point(), Point(half, 0), Point(0, half), Point(half, half)}) {
      const Box quarter{box.low + corner, box.low + corner + Point(half, half)};
      const Box reached = quarter.grown(kReach);
      within.clear();
      std::copy_if(segments.begin(), segments.end(), std::back_inserter(within),
                   [&](std::uint32_t i) { return touches(list_[i].segment, reached); });
      if (auto place = divide(quarter, within)) return place;
    }
    return std::nullopt;
  }

  CrowdedPlace placeOf(const Box& box, std::vector<std::uint32_t> segments) const {
    std::stable_sort(segments.begin(), segments.end(), [this](std::uint32_t a, std::uint32_t b) {
      return std::tie(list_[a].face, list_[a].index) < std::tie(list_[b].face, list_[b].index);
    });
    const Near& excess = list_[segments[kMost]];
    return {face_.id, box.low + Point(kPlace / 2, kPlace / 2), excess.face, excess.index};
  }

  const MapGeometry& face_;
  const List& list_;
  Box bounds_;
  std::int64_t columns_;
  std::int64_t rows_;
  std::vector<std::uint32_t> counts_;              // by tile
  std::vector<std::size_t> crowded_;               // tiles
  std::vector<std::vector<std::uint32_t>> lists_;  // indices into list_, by index in crowded_
};

Crowding::Crowding(const Geometry& faces, std::span<const std::vector<Segment>> segments)
    : faces_(faces), segments_(segments) {}

std::vector<CrowdedPlace> Crowding::find() {
  std::size_t segments = 0;
  for (const auto& face : segments_) segments += face.size();
  if (segments <= kMost) return {};
  std::vector<CrowdedPlace> found = findOnFaces();
  return found.empty() ? findAcrossEdges() : found;
}

std::vector<CrowdedPlace> Crowding::findOnFaces() const {
  std::vector<CrowdedPlace> found;
  for (std::uint32_t face = 0; face < segments_.size(); ++face) {
    if (const auto place = search(face, ownSegments(face))) found.push_back(*place);
  }
  return found;
}

std::vector<CrowdedPlace> Crowding::findAcrossEdges() {
  findBands();
  std::vector<CrowdedPlace> found;
  for (std::uint32_t face = 0; face < segments_.size(); ++face) {
    if (const auto place = search(face, segmentsNearEdges(face))) found.push_back(*place);
  }
  return found;
}

std::optional<CrowdedPlace> Crowding::search(std::uint32_t face, const List& list) const {
  if (list.size() <= kMost) return std::nullopt;
  return Search(*faces_.find(face), list).first();
}

std::size_t Crowding::most() {
  std::size_t most = 0;
  for (std::uint32_t face = 0; face < segments_.size(); ++face) most = mostOf(face, ownSegments(face), most);
  findBands();
  for (std::uint32_t face = 0; face < segments_.size(); ++face) most = mostOf(face, segmentsNearEdges(face), most);
  return std::min(most, kMost);
}

// A list that is not longer than what is known cannot raise it.
std::size_t Crowding::mostOf(std::uint32_t face, const List& list, std::size_t known) const {
  return list.size() <= known ? known : std::max(known, Search(*faces_.find(face), list).most());
}

void Crowding::findBands() {
  bands_.clear();
  for (std::uint32_t face = 0; face < segments_.size(); ++face) {
    const List own = ownSegments(face);
    std::vector<List>& bands = bands_.emplace_back();
    for (const Warp& warp : faces_.find(face)->warps) {
      const Band band(warp.from);
      List& near = bands.emplace_back();
      std::copy_if(own.begin(), own.end(), std::back_inserter(near),
                   [&band](const Near& entry) { return band.touches(entry.segment); });
    }
  }
}

Crowding::List Crowding::ownSegments(std::uint32_t face) const {
  List list;
  for (std::uint32_t i = 0; i < segments_[face].size(); ++i) list.push_back({segments_[face][i], face, i});
  return list;
}

// The segments of other faces that are within reach, and those of the face itself with which they share a place.
Crowding::List Crowding::segmentsNearEdges(std::uint32_t face) const {
  const MapGeometry& part = *faces_.find(face);
  List list = segmentsBeyond(part, part.warps.size(), maxEdgesCrossed(part));
  if (list.empty()) return list;
  const List own = ownSegments(face);
  std::vector<Band> bands;
  for (const Warp& warp : part.warps) bands.emplace_back(warp.from);
  std::copy_if(own.begin(), own.end(), std::back_inserter(list), [&bands](const Near& entry) {
    return std::any_of(bands.begin(), bands.end(), [&](const Band& band) { return band.touches(entry.segment); });
  });
  return list;
}

// The segments behind the edges of a face, except one edge, in the frame of the face. `depth`: edges that may be
// crossed.
Crowding::List Crowding::segmentsBeyond(const MapGeometry& part, std::size_t except, int depth) const {
  List list;
  for (std::size_t warp = 0; warp < part.warps.size(); ++warp) {
    if (warp != except) appendBeyond(part, warp, depth, list);
  }
  return list;
}

void Crowding::appendBeyond(const MapGeometry& part, std::size_t index, int depth, List& out) const {
  const Warp& warp = part.warps[index];
  const MapGeometry& behind = *faces_.find(warp.target);
  const std::size_t back = *faces_.reverseWarp(part.id, warp);
  const auto append = [&](const Near& near) { out.push_back({mapBack(warp, near.segment), near.face, near.index}); };
  std::for_each(bands_[behind.id][back].begin(), bands_[behind.id][back].end(), append);
  if (depth == 1) return;
  const Band band(behind.warps[back].from);
  for (const Near& near : segmentsBeyond(behind, back, depth - 1)) {
    if (band.touches(near.segment)) append(near);
  }
}

}  // namespace platon
