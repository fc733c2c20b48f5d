#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "platon/exact/point.h"
#include "platon/physics/map_geometry.h"
#include "platon/physics/segment.h"

namespace platon {

/// A place near which a level has more than kMaxSegmentsInReach segments.
struct CrowdedPlace {
  std::uint32_t face = 0;
  Point centre;                   ///< of the square that they touch, in the frame of the face
  std::uint32_t segmentFace = 0;  ///< the first segment, by face and index, that is one too many
  std::size_t segment = 0;
};

/// Searches the faces of a solid for places that have too many segments within a tick's reach of a player, on the same
/// face or over the edges. The faces are divided into squares of kPlace; a player with its centre in one of them can
/// touch, within a tick, only what touches this square grown by kReach on every side.
///
/// Takes time in proportion to the segments and to their total length; only the surroundings of crowded places are
/// examined more closely.
class Crowding {
 public:
  /// Both in subunits. kReach is more than the radius of a player and its largest displacement in a tick.
  static constexpr std::int32_t kPlace = 8 * 1024;
  static constexpr std::int32_t kReach = 36 * 1024;

  /// `faces` has a part for each face, with its warps; `segments` has the segments of each face. Both must outlive the
  /// object. The segments of a face end at most one subunit outside it.
  Crowding(const Geometry& faces, std::span<const std::vector<Segment>> segments);

  /// The first crowded place of each face that has one. Segments of other faces count only if no face is crowded by its
  /// own.
  std::vector<CrowdedPlace> find();
  /// At least as many segments as a player can touch within a tick anywhere, and at most those that touch the square of
  /// 64 units round it, grown by kReach. Not more than kMaxSegmentsInReach, which a valid level does not exceed.
  std::size_t most();

 private:
  // A segment in the frame of the face that is searched.
  struct Near {
    Segment segment;
    std::uint32_t face;  // of the level, to which it belongs
    std::uint32_t index;
  };
  using List = std::vector<Near>;
  class Search;

  std::vector<CrowdedPlace> findOnFaces() const;
  std::vector<CrowdedPlace> findAcrossEdges();
  void findBands();
  List ownSegments(std::uint32_t face) const;
  List segmentsNearEdges(std::uint32_t face) const;
  List segmentsBeyond(const MapGeometry& part, std::size_t except, int depth) const;
  void appendBeyond(const MapGeometry& part, std::size_t warp, int depth, List& out) const;
  std::optional<CrowdedPlace> search(std::uint32_t face, const List& list) const;
  std::size_t mostOf(std::uint32_t face, const List& list, std::size_t known) const;

  const Geometry& faces_;
  std::span<const std::vector<Segment>> segments_;
  std::vector<std::vector<List>> bands_;  // by face and edge: the segments of the face that are near the edge
};

}  // namespace platon
