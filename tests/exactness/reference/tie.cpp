#include "tests/exactness/reference/tie.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <vector>

#include "tests/exactness/reference/simulated_body.h"

namespace platon::reference {
namespace {

using Leg = IdealPath::Leg;
using Kind = IdealPath::Kind;

/// Paths of different obstacles are compared at every one of this many ticks.
constexpr std::int64_t kCompareTicks = 8;

/// Grown shapes are rounded to this part of a subunit.
constexpr std::int64_t kFine = 4096;

/// `place` moved by `distance` in the direction (x, y), a little more because of rounding.
Place moved(const Place& place, double distance, const mpz_class& x, const mpz_class& y) {
  const mpz_class scale(std::ldexp(distance, 20));
  const mpz_class size = sqrt(mpz_class((x * x + y * y) << 40));
  return {place.x * size + scale * x * place.d, place.y * size + scale * y * place.d, place.d * size};
}

Place toPlace(const RationalVec& v) {
  Place place{v.x.get_num() * v.y.get_den(), v.y.get_num() * v.x.get_den(), v.x.get_den() * v.y.get_den()};
  return place;
}

/// The scene in units that are kFine times as fine, with a shape whose edges are `by` subunits farther from its centre
/// (nearer if negative) along the narrowest way, and more along the others.
ExactScene withGrownShape(const ExactScene& scene, double by) {
  ExactScene fine = scaled(scene, kFine);
  const auto count = static_cast<std::int64_t>(fine.shape.size());
  oracle::Vec sum;
  for (const oracle::Vec v : fine.shape) sum = sum + v;
  const oracle::Vec centre = {sum.x / count, sum.y / count};
  double narrowest = HUGE_VAL;
  for (std::size_t i = 0; i < fine.shape.size(); ++i) {
    const oracle::Vec edge = fine.shape[(i + 1) % fine.shape.size()] - fine.shape[i];
    const auto area = static_cast<double>(oracle::cross(edge, centre - fine.shape[i]));
    narrowest = std::min(narrowest, area / std::sqrt(static_cast<double>(oracle::dot(edge, edge))));
  }
  const double share = by * static_cast<double>(kFine) / narrowest;
  for (oracle::Vec& v : fine.shape) {
    const oracle::Vec out = v - centre;
    v = v +
        oracle::Vec{std::llround(share * static_cast<double>(out.x)), std::llround(share * static_cast<double>(out.y))};
  }
  return fine;
}

/// Distance of two bodies without a tie.
double allowedSeparation(std::int64_t tick) {
  return kSeparation * std::max(1.0, static_cast<double>(tick) / kSeparationTicks);
}

/// The earliest tick at which the body with the grown shape is elsewhere.
std::optional<double> separation(const IdealPath& ideal, const IdealPath& grown, std::int64_t ticks) {
  for (std::int64_t tick = 0; tick <= ticks; tick += kCompareTicks) {
    const RationalVec other = grown.positionAt(tick);
    if (distance(ideal.positionAt(tick), {other.x / kFine, other.y / kFine}) > allowedSeparation(tick)) {
      return static_cast<double>(tick);
    }
  }
  return std::nullopt;
}

/// Whether another line comes within kJoint of this point, along both axes.
bool isAtJoint(const ExactScene& scene, std::size_t own, oracle::Vec end, std::int64_t unit) {
  const std::int64_t scale = kFine / unit;
  constexpr std::int64_t kReached = kFine * kJoint + 1;  // of an open square
  const auto area = oracle::OpenArea::placed(
      {{-kReached, -kReached}, {kReached, -kReached}, {kReached, kReached}, {-kReached, kReached}}, scale * end);
  for (std::size_t other = 0; other < scene.lines.size(); ++other) {
    const oracle::Segment& line = scene.lines[other];
    if (other != own && area.intersects({scale * line.a, scale * line.b})) return true;
  }
  return false;
}

/// Whether the body, near `place`, touches an end of this line that is at a joint.
bool touchesJoint(const ExactScene& scene, const RationalVec& place, std::size_t line, std::int64_t unit) {
  const oracle::Vec at = {std::llround(place.x.get_d()), std::llround(place.y.get_d())};
  const auto reach = static_cast<std::int64_t>(kLift) * unit;
  const auto body = oracle::OpenArea::placed(scene.shape, at).inset(-reach);
  const oracle::Segment& own = scene.lines[line];
  return (body.intersects({own.a, own.a}) && isAtJoint(scene, line, own.a, unit)) ||
         (body.intersects({own.b, own.b}) && isAtJoint(scene, line, own.b, unit));
}

/// Whether the condition holds for one of 16 directions.
template <class Condition>
bool anyDirection(Condition&& condition) {
  for (int x = -2; x <= 2; ++x) {
    for (int y = -2; y <= 2; ++y) {
      if (std::max(std::abs(x), std::abs(y)) == 2 && condition(x, y)) return true;
    }
  }
  return false;
}

/// Whether a body at rest goes on after a lift.
class Rest {
 public:
  /// `path` is in units that are `unit` times as fine as subunits.
  Rest(const ExactScene& scene, const IdealPath& path, std::int64_t ticks, std::int64_t unit)
      : scene_(scene), path_(path), ticks_(ticks), unit_(unit) {}

  bool isLoose(double lift) const {
    if (path_.legs().back().kind != Kind::kRest) return false;
    return anyDirection([&](int x, int y) { return goesOnFrom(lift, x, y); });
  }

  /// Whether no lattice point near the rest is free.
  bool isNarrow() const {
    const Leg& rest = path_.legs().back();
    if (rest.kind != Kind::kRest) return false;
    const RationalVec at = rest.start.rational();
    const mpz_class x = at.x.get_num() / at.x.get_den();
    const mpz_class y = at.y.get_num() / at.y.get_den();
    for (std::int64_t i = -kReach - 1; i <= kReach + 1; ++i) {
      for (std::int64_t j = -kReach - 1; j <= kReach + 1; ++j) {
        const Place point{x + i, y + j, 1};
        if (distance(point.rational(), at) <= kReach && path_.isFree(point)) return false;
      }
    }
    return true;
  }

  bool isAtJoint() const {
    const Leg& rest = path_.legs().back();
    if (rest.kind != Kind::kRest) return false;
    const RationalVec at = rest.start.rational();
    return touchesJoint(scene_, at, rest.along.obstacle, unit_) ||
           touchesJoint(scene_, at, rest.against.obstacle, unit_);
  }

 private:
  bool goesOnFrom(double lift, int x, int y) const {
    const Leg& rest = path_.legs().back();
    const Place lifted = moved(rest.start, lift * static_cast<double>(unit_), x, y);
    if (!path_.isFree(lifted)) return false;
    const IdealPath onwards = path_.from(lifted, rest.begin, {});
    return distance(onwards.positionAt(ticks_), rest.start.rational()) >
           allowedSeparation(ticks_) * static_cast<double>(unit_);
  }

  const ExactScene& scene_;
  const IdealPath& path_;
  std::int64_t ticks_;
  std::int64_t unit_;
};

/// Finds the ties of a scene.
class TieFinder {
 public:
  TieFinder(const ExactScene& scene, const IdealPath& ideal, std::int64_t ticks)
      : scene_(scene), ideal_(ideal), legs_(ideal.legs()), ticks_(ticks) {}

  Tie earliest() {
    addRest();
    addSlowSlides();
    for (std::size_t i = 0; i < legs_.size(); ++i) {
      const bool begins = i == 0 || legs_[i - 1].kind != Kind::kFree;
      if (legs_[i].kind != Kind::kFree || !begins) continue;
      addSidestep(i, 1);
      addSidestep(i, -1);
    }
    addGrown(kTieSubunits);
    addGrown(-kTieSubunits);
    return tie_;
  }

 private:
  void add(Tie::Kind kind, double tick) {
    if (tie_.kind == Tie::Kind::kNone || tick < tie_.tick) tie_ = {kind, tick};
  }

  static Tie::Kind kindOf(bool isSnag) { return isSnag ? Tie::Kind::kJoint : Tie::Kind::kDivided; }

  bool isSnag(const ExactScene& scene, const IdealPath& path, std::int64_t unit) const {
    const Rest rest(scene, path, ticks_, unit);
    return rest.isAtJoint() && rest.isLoose(kLift);
  }

  void addRest() {
    const Rest rest(scene_, ideal_, ticks_, 1);
    const double begin = legs_.back().begin.get_d();
    if (isSnag(scene_, ideal_, 1)) {
      add(Tie::Kind::kJoint, begin);
    } else if (rest.isNarrow()) {
      add(Tie::Kind::kNarrow, begin);
    } else if (rest.isLoose(kTieSubunits)) {
      add(Tie::Kind::kDivided, begin);
    }
  }

  void addSlowSlides() {
    const double speed = lengthOf({mpq_class(scene_.velocity.x), mpq_class(scene_.velocity.y)});
    for (const Leg& leg : legs_) {
      if (leg.kind != Kind::kSlide || ideal_.side(leg.along).alongLine) continue;
      if (lengthOf(leg.velocity) >= kSlow * speed) continue;
      if (touchesJoint(scene_, leg.start.rational(), leg.along.obstacle, 1)) add(Tie::Kind::kJoint, leg.begin.get_d());
    }
  }

  static double lengthOf(const RationalVec& v) { return distance(v, {0, 0}); }

  void addGrown(double by) {
    const ExactScene scene = withGrownShape(scene_, by);
    const IdealPath grown(scene, ticks_, kFine);
    const auto tick = separation(ideal_, grown, ticks_);
    if (tick) add(kindOf(isSnag(scene_, ideal_, 1) || isSnag(scene, grown, kFine)), *tick);
  }

  mpq_class endOfFlight(std::size_t leg) const {
    while (leg < legs_.size() && legs_[leg].kind == Kind::kFree) ++leg;
    return leg < legs_.size() ? legs_[leg].begin : mpq_class(ticks_);
  }

  /// Moves the body aside in the flight that begins with `leg`, as early as it is free there.
  void addSidestep(std::size_t leg, int side) {
    const mpq_class flight = endOfFlight(leg) - legs_[leg].begin;
    const RationalVec& v = legs_[leg].velocity;
    const RationalVec start = legs_[leg].start.rational();
    for (const int quarter : {0, 1, 2, 3}) {
      const mpq_class passed(flight.get_d() * quarter / 4);  // in short numbers
      const Place beside = moved(toPlace({start.x + passed * v.x, start.y + passed * v.y}), kTieSubunits,
                                 -side * mpz_class(scene_.velocity.y), side * mpz_class(scene_.velocity.x));
      if (ideal_.isFree(beside)) return compare(beside, leg, legs_[leg].begin + passed);
    }
  }

  void compare(const Place& beside, std::size_t leg, const mpq_class& begin) {
    bool back = false;
    const IdealPath path = ideal_.from(beside, begin, [&](const Leg& other) {
      back = other.kind != Kind::kFree && std::any_of(legs_.begin() + static_cast<std::ptrdiff_t>(leg), legs_.end(),
                                                      [&](const Leg& own) { return isSame(own, other); });
      return back;
    });
    if (back || distance(path.positionAt(ticks_), ideal_.positionAt(ticks_)) <= allowedSeparation(ticks_)) return;
    add(kindOf(isSnag(scene_, ideal_, 1) || isSnag(scene_, path, 1)), legs_[leg].begin.get_d());
  }

  static bool isSame(const Leg& a, const Leg& b) {
    if (a.kind != b.kind) return false;
    return a.kind == Kind::kSlide ? a.along == b.along
                                  : distance(a.start.rational(), b.start.rational()) <= kSeparation;
  }

  const ExactScene& scene_;
  const IdealPath& ideal_;
  const std::vector<Leg>& legs_;
  std::int64_t ticks_;
  Tie tie_;
};

}  // namespace

Tie findTie(const ExactScene& scene, const IdealPath& ideal, std::int64_t ticks) {
  return TieFinder(scene, ideal, ticks).earliest();
}

}  // namespace platon::reference
