#pragma once

#include <gmpxx.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "tests/exactness/reference/course.h"
#include "tests/exactness/reference/exact_scene.h"
#include "tests/exactness/reference/path_obstacle.h"

namespace platon::reference {

/// The ideal trajectory of a scene's body, for many ticks. Since the velocity is constant, the trajectory does not
/// depend on where a tick ends: it is a chain of straight legs, each with a constant velocity. The body moves freely
/// with the velocity up to a contact. Then it moves along the edge that it has met, with the projection of the
/// velocity, to the next contact or to the end of the edge. It rests for ever where each of two edges leads it into the
/// other one, and where it would slide by less than kRestSpeed along both axes.
///
/// The legs are exact: their ends are intersections of lines with integer coefficients, so their numbers stay short,
/// and nothing is rounded. Only the times at which the legs begin are sums over all earlier legs. A time with more than
/// kMaxTimeBits is rounded to a multiple of 2^-kTimeBits ticks, so with n legs and a speed of at most 2^21 subunits per
/// tick a position is wrong by at most n * 2^21 * 2^-kTimeBits: below 2^-200 subunits for every n below 2^35.
///
/// A path through a vertex of an obstacle enters the side that is parallel to the segment, like `Sweep`; of two others,
/// the one with which it makes the smaller angle. Of several obstacles
/// that are hit at the same time, the first in the scene counts. Shares no code with the simulation.
class IdealPath {
 public:
  static constexpr std::size_t kMaxTimeBits = 512;
  static constexpr unsigned kTimeBits = 256;
  /// Subunits a tick. The velocity is an integer, so one that should lead straight into a slanted floor is off by up to
  /// half a subunit; a body on that floor must rest all the same (I4).
  static constexpr std::int64_t kRestSpeed = 1;

  enum class Kind { kFree, kSlide, kRest };

  /// A side of an obstacle.
  struct SideRef {
    std::size_t obstacle = 0;
    std::size_t side = 0;

    friend bool operator==(SideRef, SideRef) = default;
  };

  struct Leg {
    Kind kind = Kind::kFree;
    mpq_class begin;       ///< ticks; the leg ends where the next one begins
    Place start;           ///< subunits
    RationalVec velocity;  ///< subunits per tick
    SideRef along = {};    ///< the side of a slide; of a rest, the last one
    SideRef against = {};  ///< the side that a rest is pressed against, besides `along`
  };

  /// Computes the path for `ticks` ticks. The scene is in units of 1/`unit` subunits. Throws std::runtime_error if the
  /// body starts inside an obstacle.
  IdealPath(const ExactScene& scene, std::int64_t ticks, std::int64_t unit = 1);

  /// The path of the same body from another place and time on, up to the same tick, or to the first leg for which
  /// `stops` returns true.
  IdealPath from(const Place& start, const mpq_class& begin, const std::function<bool(const Leg&)>& stops) const;

  const std::vector<Leg>& legs() const { return legs_; }
  const PathObstacle::Side& side(SideRef ref) const { return (*course_)[ref.obstacle].sides[ref.side]; }
  /// True if the body overlaps no segment at this place.
  bool isFree(const Place& place) const;

  /// Position after `tick` ticks, at most those of the constructor.
  RationalVec positionAt(std::int64_t tick) const;
  /// The last leg that begins at or before `tick`.
  const Leg& legAt(const mpq_class& tick) const;
  /// True if the body slides or rests at some time from `first` to `last`.
  bool touchesBetween(std::int64_t first, std::int64_t last) const;

 private:
  /// A straight way from the present place `at_`: after u units it has moved by u / at_.d times (x, y).
  struct Way {
    mpz_class x, y;
    mpq_class rate;   ///< multiples of (x, y) per tick
    Quotient length;  ///< in those units
  };
  struct Hit {
    Quotient way;
    SideRef side;
  };

  Way freeWay() const;
  Way wayAlong(const PathObstacle::Side& side) const;
  std::optional<Hit> hitOf(std::size_t obstacle, const Way& way) const;
  std::optional<Hit> firstHit(const Way& way) const;
  SideRef blockingSide(SideRef hit) const;
  bool leadsInto(SideRef slide, std::size_t obstacle) const;
  void addLeg(Kind kind, const Way& way, SideRef along);
  bool addRest(SideRef against);
  void advance(const Way& way, const Quotient& length);
  void compute();
  bool turn();

  std::shared_ptr<const Course> course_;
  mpz_class velocityX_;
  mpz_class velocityY_;
  std::int64_t ticks_;
  std::int64_t restSpeed_;  // in units of the scene
  std::function<bool(const Leg&)> stops_;
  std::vector<Leg> legs_;
  // The state of the computation.
  Place at_;
  mpq_class now_;
  std::optional<SideRef> contact_;
  SideRef last_;
  int turns_ = 0;  // without a move
};

}  // namespace platon::reference
