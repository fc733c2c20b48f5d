#pragma once

#include <optional>
#include <vector>

#include "tests/exactness/oracle/trace/solid_model.h"
#include "tests/exactness/oracle/trace/trace.h"
#include "tests/exactness/oracle/trace/trace_report.h"

namespace platon::oracle {

/// A blocking line with the box around it.
struct MapLine {
  Segment segment;
  Box box;
};

/// A warp with what follows from it.
struct MapWarp {
  Segment from;
  Box box;
  /// Lies in the face behind, 5 subunits past the edge, in the frame of this face and clear of that face's corners.
  Segment beyond;
  std::size_t to = 0;
  /// Index of the warp of face `to` that leads back.
  std::size_t mirror = 0;
  /// From this face's frame to that of `to`, as the ideal faces lie.
  Isometry motion;
};

struct MapFace {
  Polygon polygon;
  std::vector<MapLine> lines;
  std::vector<MapWarp> warps;
};

/// The faces of a trace, checked and made ready for checking ticks.
class TraceMap {
 public:
  /// Checks the header: faces regular, of the named solid and of one whole size, warps glue them to that solid, lines
  /// inside, every corner blocked. Nothing when it is so wrong that ticks cannot be judged; the report then says why.
  static std::optional<TraceMap> make(const TraceHeader& header, TraceReport& report);

  const std::vector<MapFace>& faces() const { return faces_; }
  const MapFace& face(std::int64_t index) const { return faces_[static_cast<std::size_t>(index)]; }
  const Polygon& shape() const { return shape_; }
  /// True for a scene: one endless face without warps.
  bool isPlane() const { return plane_; }

 private:
  friend class TraceMapMaker;
  TraceMap() = default;

  Polygon shape_;
  std::vector<MapFace> faces_;
  bool plane_ = false;
};

}  // namespace platon::oracle
