#pragma once

#include <optional>
#include <vector>

#include "tests/exactness/oracle/trace/solid_model.h"
#include "tests/exactness/oracle/trace/trace.h"
#include "tests/exactness/oracle/trace/trace_report.h"

namespace platon::oracle {

/// Compares the faces of a header with those of its solid. Each check needs the ones before it: call them in this order
/// and stop at the first that returns false.
class FaceChecks {
 public:
  FaceChecks(const SolidNumbers& solid, const TraceHeader& header, TraceReport& report)
      : solid_(solid), header_(header), report_(report) {}

  /// All faces are regular within 1 subunit, with one common whole size of 200 … 65536 units.
  bool areFacesRegular();
  /// Every edge has exactly one warp. It leads to the reversed edge of another face, within 1 subunit, and the warp of
  /// that edge leads back.
  bool areWarpsGlued();
  /// Every corner has the solid's number of faces, and all faces are connected. Together with the number of faces and
  /// of their corners this determines the solid.
  void checkCornersOfSolid() const;
  /// Every segment lies inside its face within 1 subunit, and every corner is blocked.
  void checkLines() const;

  /// Index, in the target face, of the reverse warp: the one that leads back.
  std::size_t reverseOf(std::size_t face, std::size_t warp) const;
  /// The ideal motion from the frame of `face` to that of the target face.
  Isometry motionOf(std::size_t face, std::size_t warp) const;

 private:
  /// The edge of another face that an edge is glued to.
  struct Seam {
    std::size_t face = 0;
    std::size_t edge = 0;
  };

  bool isRegular(const Polygon& polygon) const;
  bool glue(std::size_t face, std::size_t warp);
  std::optional<std::size_t> edgeAt(std::size_t face, const Segment& segment, long double tolerance) const;
  Segment edgeOf(std::size_t face, std::size_t edge) const;
  bool hasReverse(std::size_t face, std::size_t edge) const;
  std::size_t facesAroundCorner(std::size_t face, std::size_t corner) const;
  std::size_t connectedFaces() const;
  bool isInside(std::size_t face, Vec point) const;
  bool isBlocked(std::size_t face, std::size_t corner) const;
  bool isElement(std::size_t face, std::size_t line) const;
  bool blocks(const Segment& line, std::size_t face, std::size_t corner) const;
  void fail(const std::string& what) const { report_.violate("header", what); }
  void failAt(std::size_t face, const std::string& what) const { fail("face " + std::to_string(face) + ": " + what); }

  const SolidNumbers& solid_;
  const TraceHeader& header_;
  TraceReport& report_;
  long double size_ = 0;
  std::vector<std::vector<Seam>> seams_;         ///< by face and edge
  std::vector<std::vector<std::size_t>> edges_;  ///< edge of each warp, by face and warp
};

}  // namespace platon::oracle
