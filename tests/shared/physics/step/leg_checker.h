#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "platon/physics/step_observer.h"
#include "platon/physics/world.h"

namespace platon {

/// Checks every leg of a world's steps by brute force, without a grid: no instance overlaps or crosses a blocking
/// segment (I1), and every instance is at the position that its warps determine (I5). Treats warps as pierceable.
class LegChecker : public StepObserver {
 public:
  /// Whether a segment, by its index in the part, blocks an instance that is there. What the instance overlaps when
  /// that begins may be left.
  using Blocks = std::function<bool(const InstanceView& instance, std::uint32_t segment)>;

  /// The world must outlive the checker and keep its address. Without `blocks`, all segments block.
  explicit LegChecker(const World& world, Blocks blocks = {}) : world_(world), blocks_(std::move(blocks)) {}

  void leg(std::uint32_t entity, std::span<const InstanceView> instances) override;
  /// Forgets the last positions. Call after every change of positions that is not a step.
  void forget() { last_.clear(); }

  /// The violations found, one per line, limited to about 2000 characters. Empty when there are none.
  const std::string& faults() const { return faults_; }
  std::uint64_t legs() const { return legs_; }

 private:
  struct Known {
    Point position;
    Angle angle;
    std::uint32_t part;
  };

  bool blocks(const InstanceView& view, std::uint32_t segment) const;
  const Known* lastOf(std::uint32_t entity, const InstanceView& view) const;
  bool overlapped(const Known& last, const Convex& shape, std::uint32_t segment) const;
  void checkFree(std::uint32_t entity, const InstanceView& view, const Convex& shape);
  void checkPath(std::uint32_t entity, const InstanceView& view, const Convex& shape);
  void checkPlace(std::uint32_t entity, const InstanceView& view, std::span<const InstanceView> all);
  void fault(std::uint32_t entity, const InstanceView& view, const std::string& what);
  const Convex& shapeOf(std::uint32_t entity, Angle angle);

  const World& world_;
  Blocks blocks_;
  std::map<std::pair<std::uint32_t, std::uint16_t>, Known> last_;  // by entity and instance
  std::map<std::pair<const Convex*, std::int32_t>, Convex> shapes_;
  std::string faults_;
  std::uint64_t legs_ = 0;
};

}  // namespace platon
