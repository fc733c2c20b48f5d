#pragma once

#include <gmpxx.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "tests/exactness/reference/path_obstacle.h"

namespace platon::reference {

/// A number of 512 bits. `setRealPrecision` must have been called before any is made.
using Real = mpf_class;
inline constexpr mp_bitcnt_t kRealBits = 512;
void setRealPrecision();

struct RealVec {
  Real x;
  Real y;
};

/// A way from one face to another: it rotates by `turn` centidegrees and takes `from` to `onto`.
struct FaceWarp {
  oracle::Segment edge;  ///< on its left is the face
  std::size_t target = 0;
  std::int64_t turn = 0;
  RealVec from;
  RealVec onto;
};

/// The segments of a face and the warps to its neighbours.
struct SolidFace {
  std::vector<oracle::Segment> lines;
  std::vector<FaceWarp> warps;
};

/// Faces, and the shape of a body by its rotation on a face, in centidegrees below 36000.
struct SolidScene {
  std::vector<SolidFace> faces;
  std::map<std::int64_t, oracle::Polygon> shapes;
};

/// The path of an ideal body over the edges of a solid: it moves straight, slides along segments and rests as on one
/// face (see IdealPath), and collides on every face that it reaches. Warps are taken as built, with their midpoints and
/// exact rotations.
///
/// Positions are numbers of 512 bits. One operation is wrong by less than 2^-480 of a coordinate below 2^20, and a leg
/// has fewer than 2^10 operations, so after 2^30 legs a position is wrong by less than 2^-420 subunits, where no tie
/// multiplies it. Places nearer than 2^-kOnEdgeBits subunits to an edge are on it: corners that are exact on the
/// lattice of one face are not exact on the next one.
class SolidPath {
 public:
  static constexpr unsigned kOnEdgeBits = 200;

  SolidPath(const SolidScene& scene, std::size_t face, oracle::Vec start);

  /// Moves by `velocity`, given in a frame that is rotated by -`heading` centidegrees against that of the face. Throws
  /// std::runtime_error if the body is inside an obstacle.
  void tick(oracle::Vec velocity, std::int64_t heading);
  /// Moves the body aside by `offset`, whatever is there.
  void displace(const RealVec& offset);
  /// Writes the place in the frame of the neighbouring face `target`. Changes the frame only.
  void changeFrame(std::size_t target);

  std::size_t face() const { return face_; }
  const RealVec& place() const { return place_; }
  /// Centidegrees by which frames have turned since the start.
  std::int64_t turned() const { return turned_; }
  /// True if at every lattice point within `distance` subunits of the place the body overlaps a segment: on its own
  /// face, or at the lattice point nearest to its image on another face that it reaches.
  bool isNarrow(std::int64_t distance) const;
  /// True if the last tick had a contact.
  bool touched() const { return touched_; }
  /// True if the body has rested on the end of a segment at a joint, or slid on one at less than 1/32 of its speed. I3
  /// forbids that to the simulation. At a joint, another segment is within 7 subunits of the end along both axes, or 11
  /// on another face.
  bool wasStoppedAtJoint() const { return stoppedAtJoint_; }

 private:
  /// The body on one face: a place p of the home frame is rotated and shifted.
  struct Image {
    std::size_t parent = 0;  // the image over whose edge it is reached; of the first one, itself
    std::size_t face = 0;
    std::int64_t turn = 0;
    RealVec rotation;  // cosine and sine
    RealVec shift;
    std::vector<PathObstacle> near;
    std::vector<std::size_t> lines;  // of the face, by obstacle
  };
  struct SideRef {
    std::size_t image = 0;
    std::size_t obstacle = 0;
    std::size_t side = 0;
  };
  /// A straight way in the home frame.
  struct Way {
    RealVec velocity;
    Real time;  // at which it ends, in ticks from now
    bool rests = false;
  };
  struct Hit {
    Real time;
    SideRef side;
  };

  void addReached(const RealVec& displacement);
  void addImage(std::size_t parent, std::size_t face, std::int64_t turn, const RealVec& shift);
  const oracle::Polygon& shapeOf(const Image& image) const;
  bool isTooFar(const Image& image, const FaceWarp& warp, const RealVec& displacement) const;
  const PathObstacle& obstacle(SideRef ref) const { return images_[ref.image].near[ref.obstacle]; }
  const PathObstacle::Side& side(SideRef ref) const { return obstacle(ref).sides[ref.side]; }
  Way wayAlong(SideRef ref) const;
  std::optional<Hit> hitOf(SideRef obstacle, const Way& way) const;
  std::optional<Hit> firstHit(const Way& way) const;
  std::optional<Hit> firstHitOnAnyFace(const Way& way);
  SideRef blockingSide(SideRef hit) const;
  bool turn(Real& left);
  bool isFree(oracle::Vec place) const;
  bool isAtJoint(SideRef ref) const;

  const SolidScene* scene_;
  std::size_t face_;
  RealVec place_;
  std::int64_t turned_ = 0;
  bool touched_ = false;
  bool stoppedAtJoint_ = false;
  // Of the present tick.
  RealVec velocity_;
  std::vector<Image> images_;
  std::optional<SideRef> contact_;
};

/// Cosine and sine of an angle in centidegrees, wrong by less than 2^-500.
RealVec directionOf(std::int64_t centidegrees);

}  // namespace platon::reference
