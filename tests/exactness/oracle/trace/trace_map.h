#pragma once

#include <optional>
#include <vector>

#include "tests/exactness/oracle/trace/solid_model.h"
#include "tests/exactness/oracle/trace/trace.h"
#include "tests/exactness/oracle/trace/trace_report.h"

namespace platon::oracle {

/// A segment and its bounding box. It blocks always, unless it is an element.
struct MapLine {
  Segment segment;
  Box box;
  std::int64_t element = -1;  ///< index of the element; -1 if it is none
};

enum class Word { kOneway, kUp, kHazard, kCheckpoint, kKey, kDoor, kPlate, kTimed };

/// A segment with a word, which decides when it blocks.
struct MapElement {
  std::int64_t face = 0;
  Segment segment;
  Word word = Word::kOneway;
  std::int64_t number = -1;  ///< the number after the word; -1 if there is none
  std::int64_t second = -1;  ///< the number after that; -1 if there is none
};

/// A warp, with values derived from it.
struct MapWarp {
  Segment from;
  Box box;
  /// A segment in the adjacent face, 5 subunits beyond the edge and away from its corners; in the frame of this face.
  Segment beyond;
  std::size_t to = 0;
  /// Index of the warp of face `to` that leads back.
  std::size_t reverse = 0;
  /// Ideal motion from the frame of this face to that of face `to`.
  Isometry motion;
};

struct MapFace {
  std::size_t edges = 0;
  std::vector<MapLine> lines;
  std::vector<MapWarp> warps;
};

/// The faces of a trace, prepared for the checks of its ticks.
class TraceMap {
 public:
  /// Checks the header: the faces are regular and of one whole size, the warps glue them to the named solid, segments
  /// lie inside their faces, every corner is blocked, and elements have a known word. Reports violations; returns
  /// nothing if ticks cannot be checked.
  static std::optional<TraceMap> make(const TraceHeader& header, TraceReport& report);

  const std::vector<MapFace>& faces() const { return faces_; }
  const MapFace& face(std::int64_t index) const { return faces_[static_cast<std::size_t>(index)]; }
  const Polygon& shape() const { return shape_; }
  const std::vector<MapElement>& elements() const { return elements_; }
  const MapElement& element(std::int64_t index) const { return elements_[static_cast<std::size_t>(index)]; }

 private:
  friend class TraceMapBuilder;
  TraceMap() = default;

  Polygon shape_;
  std::vector<MapFace> faces_;
  std::vector<MapElement> elements_;
};

}  // namespace platon::oracle
