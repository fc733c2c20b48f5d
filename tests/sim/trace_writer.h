#pragma once

#include <cstdint>
#include <cstdio>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "platon/game/element.h"
#include "platon/game/level.h"
#include "platon/physics/convex.h"
#include "platon/physics/step_observer.h"
#include "platon/physics/world.h"
#include "tests/sim/files.h"

namespace platon::sim {

/// Writes a trace as JSON lines: first all static geometry with the elements, then one line per tick with what is
/// open and the legs of every entity.
class TraceWriter : public StepObserver {
 public:
  /// Throws UsageError when `path` cannot be written.
  explicit TraceWriter(const std::string& path) : file_(path, OutputFile::Mode::kInPlace) {}

  /// Writes the header line. `level` is null for a scene.
  void header(const World& world, const Convex& shape, const Level* level);
  void leg(std::uint32_t entity, std::span<const InstanceView> instances) override;
  /// Writes the line of tick `number`, with all legs since the last call. `open`: what was open during the tick, as
  /// Game::open returned before it.
  void tick(std::uint64_t number, std::uint64_t hash, OpenElements open = {});
  /// Flushes the file; must be called after the last tick.
  void close() { file_.close(); }

 private:
  void put(std::string_view text) { line_ += text; }
  void put(std::int64_t number);
  void put(Point point);
  void put(const Segment& line);
  void put(const InstanceView& instance);
  void put(const Element& element);
  void putShape(const Convex& shape);
  void putFace(const MapGeometry& part, const std::vector<Point>& polygon);
  void putOpen(OpenElements open);
  const std::string& rotatedShape(Angle angle);
  void flushLine();

  OutputFile file_;
  std::string line_;
  std::map<std::uint32_t, std::string> legs_;  // JSON of the legs of this tick, by entity
  std::optional<Convex> shape_;
  std::vector<Element> elements_;
  std::map<std::int32_t, std::string> shapes_;  // JSON by angle; empty where the vertices equal those of the header
};

}  // namespace platon::sim
