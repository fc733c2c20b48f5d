#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "platon/physics/entity.h"
#include "platon/physics/rules.h"
#include "platon/physics/sweep.h"
#include "shared/physics/instances.h"
#include "shared/physics/region.h"

namespace platon {

/// The line that stops a leg, or a warp line that it comes near.
struct LegHit {
  std::size_t placement = 0;
  std::uint32_t line = 0;  ///< index into the lines of the placement's part
  Hit hit;                 ///< its time is of the leg
};

/// Asks exact questions about one entity's instances and the lines round them. Rules decide which lines block.
class Collider {
 public:
  /// Regions cover this much beyond the straight path of a leg: room for its margins, and for candidates for its end.
  static constexpr std::int32_t kReach = 8;
  static constexpr std::uint32_t kNoLine = ~std::uint32_t{0};

  /// A pierceable line that an instance has met.
  struct Pierced {
    std::uint16_t instance;
    std::uint32_t part;
    std::uint32_t line;

    friend bool operator==(const Pierced&, const Pierced&) = default;
  };

  /// A warp of a placement.
  struct Gate {
    std::size_t placement;
    std::uint16_t warp;

    friend bool operator==(const Gate&, const Gate&) = default;
  };
  /// A move of shapes grown by a margin.
  struct Path {
    Point from;
    Point to;
    std::int32_t margin = 0;
  };

  /// `regions` are the entity's, one for each placement's region index.
  void begin(Rules& rules, Entity entity, std::vector<Region>& regions);

  /// The earliest blocking line in the way of any instance when home moves straight from `from` to `to`; at equal
  /// times the first placement and the line with the lowest index. Notes the pierceable lines met. As if the line of
  /// `but` were not there.
  std::optional<LegHit> first(const Instances& instances, Point from, Point to, const LegHit* but = nullptr);
  /// As above for placement `index` alone and without line `but`; replaces `best` when it finds an earlier one.
  void first(const Instances& instances, std::size_t index, Point from, Point to, std::optional<LegHit>& best,
             std::uint32_t but = kNoLine);
  /// The earliest pierceable warp line, without an instance behind it and not among `shut`, that any instance meets
  /// before `limit`. To be asked after `first` for the same way, whose regions it searches; margin <= kReach.
  std::optional<LegHit> firstWarp(const Instances& instances, const Path& path, const std::optional<LegHit>& limit,
                                  const std::vector<Gate>& shut);
  /// Whether `shape`, grown by `margin`, meets a pierceable warp line of the placement that has no instance behind it.
  bool meetsWarp(const Instances& instances, const Gate& gate, const Convex& shape, std::int32_t margin);

  /// Whether no blocking line is in the way of any instance when home moves straight from `from` to `to`.
  bool isFree(const Instances& instances, Point from, Point to);
  /// The same for one placement in its own part's frame; from = to asks whether it may stand there.
  bool isFree(const Placement& placement, Point from, Point to);
  /// The first blocking line, by index, that overlaps `shape` at the placement's position.
  std::optional<std::uint32_t> overlapped(const Placement& placement, const Convex& shape);
  /// Appends the pierceable lines, by index, that the placement overlaps where it stands.
  void appendPierced(const Placement& placement, std::vector<Pierced>& out);

  /// What one line does to one placement that moves along `path` in its own part's frame.
  std::optional<Sweep::Meeting> against(const Placement& placement, const Path& path, std::uint32_t line);
  std::optional<Hit> hit(const Placement& placement, const Path& path, std::uint32_t line);

  const std::vector<Pierced>& pierced() const { return pierced_; }

 private:
  Region& start(const Placement& placement, const Convex& shape, Point from, Point to);
  Region& regionOf(const Placement& placement) { return (*regions_)[placement.region]; }
  bool isSettled(const std::optional<LegHit>& best) const {
    return ignoresWarps_ && best && best->hit.time.numerator == 0;
  }
  std::optional<Sweep::Meeting> meet(const Placement& placement, Region& region, std::size_t place);
  Obstacle* obstacleNear(const Placement& placement, const Path& path, std::uint32_t line);
  std::size_t endOfHeeded(const Region& region) const {
    return ignoresWarps_ ? region.firstWarp() : region.lines().size();
  }
  bool blocks(const MapGeometry& part, std::uint32_t line) const;
  bool blocksOrNote(const Placement& placement, std::uint32_t line);

  Rules* rules_ = nullptr;
  bool ignoresWarps_ = false;  // the rules: warps neither block nor are noted
  std::optional<Entity> entity_;
  std::vector<Region>* regions_ = nullptr;
  std::vector<Pierced> pierced_;
  Sweep sweep_;
};

/// `line` of `part` as rules see it.
SegmentRef segmentRef(const MapGeometry& part, std::uint32_t line);

}  // namespace platon
