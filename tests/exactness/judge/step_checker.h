#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "platon/game/solid.h"
#include "platon/physics/convex.h"
#include "platon/physics/map_geometry.h"
#include "platon/physics/step_observer.h"
#include "tests/exactness/oracle/trace/motion_checker.h"

namespace platon::judge {

/// What the checkers must know of a world. Whatever is referred to must outlive them.
struct JudgedScene {
  const Geometry& geometry;
  const Convex& shape;             ///< of every entity
  std::optional<SolidKind> solid;  ///< none: an endless plane, part 0
  std::int32_t faceSize = 0;       ///< level units; 0 on the plane
  /// Whether line `index` of a part lets entities pass; warp lines always do. Empty: none does.
  std::function<bool(std::uint32_t part, std::uint32_t index)> pierces = {};
};

/// Hands every leg of a world's steps to the checkers of the oracle: I1, I2, I5, I6 and I7.
class StepChecker : public StepObserver {
 public:
  explicit StepChecker(const JudgedScene& scene);

  void leg(std::uint32_t entity, std::span<const InstanceView> instances) override;
  /// Judges all legs since the last call. What is wrong; empty when nothing is.
  std::string finishTick();
  /// Moves in the last tick judged.
  std::size_t moves(std::uint32_t entity) const;
  /// Instances after the last tick judged.
  std::size_t instances(std::uint32_t entity) const;
  /// Whether the shape, turned by `angle`, may stand there.
  bool isFree(std::uint32_t part, Point position, Angle angle);

 private:
  struct Checkers;
  struct Tally {
    std::size_t moves = 0;
    std::size_t instances = 0;
  };
  oracle::TraceInstance converted(const InstanceView& view) const;
  void judge(const std::vector<oracle::TraceLeg>& legs);

  const Convex& shape_;
  oracle::TraceReport report_;
  std::shared_ptr<Checkers> checkers_;
  std::map<std::uint32_t, std::vector<oracle::TraceLeg>> legs_;  // by entity, of this tick
  std::map<std::uint32_t, Tally> tallies_;
};

}  // namespace platon::judge
