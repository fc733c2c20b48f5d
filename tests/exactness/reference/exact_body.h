#pragma once

#include <gmpxx.h>

#include <cstddef>
#include <optional>
#include <vector>

#include "tests/exactness/reference/exact_scene.h"
#include "tests/exactness/reference/rational_vec.h"

namespace platon::reference {

/// Computes the ideal trajectory of a scene's body. The body moves straight to the exact contact, then slides: the
/// projection of the remaining displacement onto the edge moves it to the next contact or to the end of the edge, after
/// which it moves freely. All numbers are rationals and nothing is rounded, so the error is zero. Shares no code with
/// the simulation.
///
/// The motion of a tick ends early if the body is wedged: sliding along either of two edges leads into the other. A
/// path through a vertex of an obstacle enters the side parallel to the segment, like `Sweep`.
class ExactBody {
 public:
  /// Largest number of bits of a coordinate. Rationals grow with every edge; a longer one is an error.
  static constexpr std::size_t kMaxBits = std::size_t{1} << 16;

  explicit ExactBody(const ExactScene& scene);

  /// Moves by one tick. Throws std::runtime_error if a coordinate needs more than kMaxBits, or if the body starts
  /// inside an obstacle.
  void tick();

  const RationalVec& position() const { return position_; }
  /// Number of legs so far, including those of length zero.
  std::size_t legs() const { return legs_; }
  /// Bits of the largest numerator or denominator of the position.
  std::size_t bits() const;

 private:
  /// A side of an obstacle: (x, y) . p < bound inside. `start` and `end` are in counter-clockwise order.
  struct Side {
    mpz_class x, y, bound, squaredLength;
    oracle::Vec start, end;
    bool alongLine;
    std::size_t before, after;  // indices of the adjacent sides
  };
  struct Obstacle {
    std::vector<Side> sides;
    oracle::Box box;
  };
  struct Hit {
    mpq_class time;
    const Obstacle* obstacle;
    const Side* side;
  };
  /// A slide along a side up to its end. It uses `fraction` of the remaining displacement.
  struct Slide {
    RationalVec displacement;
    mpq_class fraction;
  };

  static std::optional<Hit> hitOf(const Obstacle& obstacle, const RationalVec& from, const RationalVec& by);
  std::optional<Hit> firstHit(const RationalVec& by) const;
  static RationalVec along(const Side& side, const RationalVec& remaining);
  Slide slide(const Side& side, const RationalVec& remaining) const;
  /// The side that blocks the body: the side hit, or the adjacent one if the body is already at the end of that side.
  const Side* blockingSide(const Hit& hit, const RationalVec& remaining) const;
  void advance(const mpq_class& time, const RationalVec& by);

  std::vector<Obstacle> obstacles_;
  RationalVec velocity_;
  RationalVec position_;
  std::size_t legs_ = 0;
};

}  // namespace platon::reference
