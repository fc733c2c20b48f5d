#pragma once

#include <cstdint>
#include <cstdio>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "platon/game/level.h"
#include "platon/physics/convex.h"
#include "platon/physics/step_observer.h"
#include "platon/physics/world.h"
#include "tests/sim/files.h"

namespace platon::sim {

/// Writes the trace of the contract: a header line with all static geometry, then one JSON line a tick.
class TraceWriter : public StepObserver {
 public:
  /// Throws UsageError when `path` cannot be written.
  explicit TraceWriter(const std::string& path) : file_(path) {}

  /// `level` is null for a scene, which has one face without warps.
  void header(const World& world, const Convex& shape, const Level* level);
  void leg(std::uint32_t entity, std::span<const InstanceView> instances) override;
  /// Ends the tick; all legs since the last call belong to it.
  void tick(std::uint64_t number, std::uint64_t hash);
  /// To be called after the last tick.
  void close() { file_.close(); }

 private:
  void put(std::string_view text) { line_ += text; }
  void put(std::int64_t number);
  void put(Point point);
  void put(const Segment& line);
  void put(const InstanceView& instance);
  void putShape(const Convex& shape);
  void putFace(const MapGeometry& part, const std::vector<Point>& polygon);
  const std::string& turnedShape(Angle angle);
  void flushLine();

  OutputFile file_;
  std::string line_;
  std::map<std::uint32_t, std::string> legs_;  // by entity, the leg entries of this tick
  std::optional<Convex> shape_;
  std::map<std::int32_t, std::string> shapes_;  // by angle, empty where the vertices are the header's
};

}  // namespace platon::sim
