#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "platon/game/element.h"
#include "platon/game/solid.h"
#include "platon/physics/convex.h"
#include "platon/physics/map_geometry.h"
#include "platon/physics/step_observer.h"
#include "tests/exactness/oracle/trace/motion_checker.h"

namespace platon::step_check {

/// The static data of a world that the checkers need. The referenced objects must outlive the checker.
struct CheckedScene {
  const Geometry& geometry;
  const Convex& shape;             ///< shape of every entity
  std::optional<SolidKind> solid;  ///< nothing: an infinite plane, part 0
  std::int32_t faceSize = 0;       ///< level units; 0 on the plane
  /// True if entities pass segment `index` of a part. They always pass warp segments. An empty function: they pass no
  /// other.
  std::function<bool(std::uint32_t part, std::uint32_t index)> pierces = {};
  /// The segments with a word, if entities are players: they block by their words. Empty if `pierces` is given.
  std::span<const Element> elements = {};
};

/// Checks every leg of a world's steps with the oracle: invariants I1, I2, I5, I6 and I7.
class StepChecker : public StepObserver {
 public:
  explicit StepChecker(const CheckedScene& scene);

  void leg(std::uint32_t entity, std::span<const InstanceView> instances) override;
  /// Checks all legs since the last call. `open`: what was open. Returns the first violation since construction; empty
  /// if there is none.
  std::string finishTick(OpenElements open = {});
  /// Number of elements that entities have passed.
  std::size_t elementsPassed() const { return report_.elementsPassed.size(); }
  /// Moves of the entity in the last checked tick.
  std::size_t moves(std::uint32_t entity) const;
  /// Instances of the entity after the last checked tick.
  std::size_t instances(std::uint32_t entity) const;
  /// True if the shape, rotated by `angle`, overlaps no segment at `position`.
  bool isFree(std::uint32_t part, Point position, Angle angle);

 private:
  struct Checkers;
  struct Tally {
    std::size_t moves = 0;
    std::size_t instances = 0;
  };
  oracle::TraceInstance converted(const InstanceView& view) const;
  void checkStep(const std::vector<oracle::TraceLeg>& legs);

  const Convex& shape_;
  std::span<const Element> elements_;
  oracle::TraceReport report_;
  std::shared_ptr<Checkers> checkers_;
  std::map<std::uint32_t, std::vector<oracle::TraceLeg>> legs_;  // legs of this tick, by entity
  std::map<std::uint32_t, Tally> tallies_;
};

}  // namespace platon::step_check
