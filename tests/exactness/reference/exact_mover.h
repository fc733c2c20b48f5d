#pragma once

#include <gmpxx.h>

#include <cstddef>
#include <optional>
#include <vector>

#include "tests/exactness/reference/exact_scene.h"

namespace platon::reference {

/// A point or vector with rational coordinates of any size.
struct RationalVec {
  mpq_class x;
  mpq_class y;
};

/// Follows the ideal trajectory of a scene's mover: it goes straight to the exact point of contact; from there the part
/// of what it wants that leads along the edge entered takes it on, to the next contact or to the end of that edge,
/// where it is as free as before. All numbers are rationals and none is ever rounded, so that the error is zero. Shares
/// nothing with the world that it judges.
///
/// A displacement ends early where the mover is wedged: where the edge met next sends it back to the one that it slides
/// along. Through a corner of an obstacle the side along the line is entered, as the sweep has it.
class ExactMover {
 public:
  /// Rationals grow with every new edge: a position that needs more bits than this is given up.
  static constexpr std::size_t kMaxBits = std::size_t{1} << 16;

  explicit ExactMover(const ExactScene& scene);

  /// Moves by one tick. Throws std::runtime_error when the numbers outgrow kMaxBits.
  void tick();

  const RationalVec& position() const { return position_; }
  /// Straight pieces of the way so far, those of length zero included.
  std::size_t legs() const { return legs_; }
  /// Bits of the largest numerator or denominator of the position.
  std::size_t bits() const;

 private:
  /// outward . p < bound inside the obstacle; from `start` to `end` counter-clockwise.
  struct Side {
    mpz_class x, y, bound, squaredLength;
    oracle::Vec start, end;
    bool alongLine;
    std::size_t before, after;  // the neighbours, by index
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
  /// Along a side, as far as it goes; `share` of what is left of the displacement takes it there.
  struct Slide {
    RationalVec way;
    mpq_class share;
  };

  static std::optional<Hit> meet(const Obstacle& obstacle, const RationalVec& from, const RationalVec& by);
  std::optional<Hit> first(const RationalVec& by) const;
  static RationalVec along(const Side& side, const RationalVec& rest);
  Slide slide(const Side& side, const RationalVec& rest) const;
  /// At the end of a side, the next one where that holds the mover, too.
  const Side* holding(const Hit& hit, const RationalVec& rest) const;
  void advance(const mpq_class& time, const RationalVec& by);

  std::vector<Obstacle> obstacles_;
  RationalVec velocity_;
  RationalVec position_;
  std::size_t legs_ = 0;
};

}  // namespace platon::reference
