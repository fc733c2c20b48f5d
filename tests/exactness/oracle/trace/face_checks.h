#pragma once

#include <optional>
#include <vector>

#include "tests/exactness/oracle/trace/solid_model.h"
#include "tests/exactness/oracle/trace/trace.h"
#include "tests/exactness/oracle/trace/trace_report.h"

namespace platon::oracle {

/// Compares the faces of a header with those of its solid. The checks build on each other: call them in this order and
/// stop at the first `false`.
class FaceChecks {
 public:
  FaceChecks(const SolidNumbers& solid, const TraceHeader& header, TraceReport& report)
      : solid_(solid), header_(header), report_(report) {}

  /// Every face is the ideal one to 1 subunit, all of the same whole size of 200 … 65536 units.
  bool areFacesRegular();
  /// Every edge has one warp, whose other end is the reversed edge of another face to 1 subunit, and that edge's warp
  /// leads back.
  bool areWarpsGlued();
  /// As many faces meet at every corner as at the solid's, and all faces hang together: with the numbers of faces and
  /// corners there is then only one such solid.
  void checkCornersOfSolid() const;
  /// Every line lies inside its face to 1 subunit, and every corner is blocked.
  void checkLines() const;

  /// Index of the warp that leads back through this one.
  std::size_t mirrorOf(std::size_t face, std::size_t warp) const;
  /// The ideal motion into the frame of the face behind.
  Isometry motionOf(std::size_t face, std::size_t warp) const;

 private:
  /// Where an edge leads: another face's edge.
  struct Seam {
    std::size_t face = 0;
    std::size_t edge = 0;
  };

  bool isRegular(const Polygon& polygon) const;
  bool glue(std::size_t face, std::size_t warp);
  std::optional<std::size_t> edgeAt(std::size_t face, const Segment& segment, long double tolerance) const;
  Segment edgeOf(std::size_t face, std::size_t edge) const;
  bool leadsBack(std::size_t face, std::size_t edge) const;
  std::size_t facesRound(std::size_t face, std::size_t corner) const;
  std::size_t facesReached() const;
  bool isInside(std::size_t face, Vec point) const;
  bool isBlocked(std::size_t face, std::size_t corner) const;
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
