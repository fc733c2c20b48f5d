#include "tests/exactness/reference/solid_path.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace platon::reference {
namespace {

using oracle::Vec;
using Side = PathObstacle::Side;

constexpr std::int64_t kFullTurn = 36000;
constexpr std::size_t kMaxImages = 24;
constexpr int kMaxTurnsOfTick = 1000;
/// Half-widths of open squares: one more than in the simulation.
constexpr std::int64_t kJoint = 8;
constexpr std::int64_t kJointAcross = 12;
constexpr long kReach = 6;  // subunits at which a body reaches an edge of the face; segments do not lie beyond it

/// Times nearer than this are equal, in ticks: far more than kOnEdgeBits makes of it at the smallest angles.
Real sameTime() { return Real(1) >> 140; }

Real toReal(const mpz_class& number) { return Real(number, kRealBits); }
Real inverse(std::int64_t number) { return Real(1) / number; }

RealVec operator+(const RealVec& a, const RealVec& b) { return {a.x + b.x, a.y + b.y}; }
RealVec operator-(const RealVec& a, const RealVec& b) { return {a.x - b.x, a.y - b.y}; }
RealVec operator*(const Real& k, const RealVec& a) { return {k * a.x, k * a.y}; }
Real dot(const RealVec& a, const RealVec& b) { return a.x * b.x + a.y * b.y; }
RealVec toReal(Vec v) { return {Real(static_cast<long>(v.x)), Real(static_cast<long>(v.y))}; }

RealVec turnedBy(const RealVec& direction, const RealVec& v) {
  return {direction.x * v.x - direction.y * v.y, direction.y * v.x + direction.x * v.y};
}
RealVec turnedBack(const RealVec& direction, const RealVec& v) { return turnedBy({direction.x, -direction.y}, v); }

RealVec normalOf(const Side& side) { return {toReal(side.x), toReal(side.y)}; }
Real toleranceOf(const Side& side) { return toReal(mpz_class(abs(side.x) + abs(side.y))) >> SolidPath::kOnEdgeBits; }

/// atan(1 / n).
Real arctangent(std::int64_t n) {
  const Real square = inverse(n * n);
  Real power = inverse(n);
  Real sum = power;
  for (std::int64_t k = 3; k < 600; k += 2) {
    power *= -square;
    sum += power / static_cast<long>(k);
  }
  return sum;
}

const Real& pi() {
  static const Real value = 16 * arctangent(5) - 4 * arctangent(239);  // Machin
  return value;
}

RealVec powerSeries(const Real& radians) {
  RealVec sum{1, 0};
  Real term = 1;
  for (long k = 1; k < 300; ++k) {
    term *= radians / k;
    (k % 2 == 0 ? sum.x : sum.y) += k % 4 < 2 ? term : Real(-term);
  }
  return sum;
}

std::int64_t normalized(std::int64_t centidegrees) { return (centidegrees % kFullTurn + kFullTurn) % kFullTurn; }

Vec rounded(const RealVec& v) { return {std::llround(v.x.get_d()), std::llround(v.y.get_d())}; }

}  // namespace

void setRealPrecision() { mpf_set_default_prec(kRealBits); }

RealVec directionOf(std::int64_t centidegrees) {
  static std::map<std::int64_t, RealVec> known;
  const std::int64_t turn = normalized(centidegrees);
  const auto found = known.find(turn);
  if (found != known.end()) return found->second;
  return known.emplace(turn, powerSeries(pi() * static_cast<long>(turn) / (kFullTurn / 2))).first->second;
}

SolidPath::SolidPath(const SolidScene& scene, std::size_t face, Vec start)
    : scene_(&scene), face_(face), place_(toReal(start)) {}

void SolidPath::displace(const RealVec& offset) { place_ = place_ + offset; }

void SolidPath::changeFrame(std::size_t target) {
  for (const FaceWarp& warp : scene_->faces[face_].warps) {
    if (warp.target != target) continue;
    place_ = warp.onto + turnedBy(directionOf(warp.turn), place_ - warp.from);
    face_ = target;
    turned_ += warp.turn;
    return;
  }
  throw std::runtime_error("the face has no such neighbour");
}

// Adds the faces that the body reaches on its way; near a corner, one face may be reached on two ways.
void SolidPath::addReached(const RealVec& displacement) {
  for (std::size_t i = 0; i < images_.size() && images_.size() < kMaxImages; ++i) {
    for (const FaceWarp& warp : scene_->faces[images_[i].face].warps) {
      const bool isKnown = images_[images_[i].parent].face == warp.target ||
                           std::any_of(images_.begin(), images_.end(), [&](const Image& other) {
                             return other.face == warp.target && other.parent == i;
                           });
      if (isKnown || isTooFar(images_[i], warp, displacement)) continue;
      const RealVec shift = turnedBy(directionOf(warp.turn), images_[i].shift - warp.from) + warp.onto;
      addImage(i, warp.target, images_[i].turn + warp.turn, shift);
    }
  }
}

const oracle::Polygon& SolidPath::shapeOf(const Image& image) const {
  return scene_->shapes.at(normalized(turned_ + image.turn));
}

// With the segments that it may touch in this tick.
void SolidPath::addImage(std::size_t parent, std::size_t face, std::int64_t turn, const RealVec& shift) {
  Image& image = images_.emplace_back(Image{parent, face, turn, directionOf(turn), shift, {}, {}});
  const Vec at = rounded(turnedBy(image.rotation, place_) + shift);
  const Vec speed = rounded(velocity_);
  const oracle::Box box = oracle::Box{at, at}.grown(std::abs(speed.x) + std::abs(speed.y) + 4);
  const std::vector<oracle::Segment>& lines = scene_->faces[face].lines;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    PathObstacle obstacle(shapeOf(image), lines[i]);
    if (!box.touches(obstacle.box)) continue;
    image.near.push_back(std::move(obstacle));
    image.lines.push_back(i);
  }
}

// Whether the body, on its way, does not come near the edge of the face: the way and the obstacle of the edge are
// separated by a side of the obstacle or by the way.
bool SolidPath::isTooFar(const Image& image, const FaceWarp& warp, const RealVec& displacement) const {
  const RealVec at = turnedBy(image.rotation, place_) + image.shift;
  const RealVec by = turnedBy(image.rotation, displacement);
  const PathObstacle edge(shapeOf(image), warp.edge);
  const Real length = sqrt(dot(by, by));
  const auto isBeside = [&](int sign) {
    return std::all_of(edge.sides.begin(), edge.sides.end(), [&](const Side& side) {
      const RealVec corner = toReal(side.start) - at;
      return sign * (by.x * corner.y - by.y * corner.x) > kReach * length;
    });
  };
  return isBeside(1) || isBeside(-1) || std::any_of(edge.sides.begin(), edge.sides.end(), [&](const Side& side) {
           const RealVec normal = normalOf(side);
           const Real beyond = dot(normal, at) - toReal(side.bound);
           const Real change = dot(normal, by);
           return (change < 0 ? Real(beyond + change) : beyond) > kReach * sqrt(dot(normal, normal));
         });
}

// The way to the end of the side to which the velocity leads. Its time is zero if the body is there.
SolidPath::Way SolidPath::wayAlong(SideRef ref) const {
  const Image& image = images_[ref.image];
  const Side& edge = side(ref);
  const RealVec normal = normalOf(edge);
  const RealVec wanted = turnedBy(image.rotation, velocity_);
  const Real speed = normal.x * wanted.y - normal.y * wanted.x;
  const Real square = dot(normal, normal);
  const Real share = speed / square;
  const RealVec along{-normal.y * share, normal.x * share};
  Way way{turnedBack(image.rotation, along), 0, abs(along.x) < 1 && abs(along.y) < 1};
  if (way.rests) return way;
  const RealVec at = turnedBy(image.rotation, place_) + image.shift;
  way.time = dot(toReal(speed > 0 ? edge.end : edge.start) - at, along) / dot(along, along);
  if (way.time < sameTime()) way.time = 0;
  return way;
}

// Clips the way against all sides (Cyrus-Beck).
std::optional<SolidPath::Hit> SolidPath::hitOf(SideRef ref, const Way& way) const {
  const Image& image = images_[ref.image];
  const RealVec at = turnedBy(image.rotation, place_) + image.shift;
  const RealVec velocity = turnedBy(image.rotation, way.velocity);
  const std::vector<Side>& sides = obstacle(ref).sides;
  std::optional<Hit> enter;
  std::optional<Real> leave;
  Real steepness;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const RealVec normal = normalOf(sides[i]);
    const Real beyond = dot(normal, at) - toReal(sides[i].bound);
    const Real inwards = -dot(normal, velocity);
    const Real tolerance = toleranceOf(sides[i]);
    if (beyond < -tolerance) {
      if (inwards < 0 && (!leave || beyond / inwards < *leave)) leave = beyond / inwards;
      continue;
    }
    if (beyond - inwards * way.time >= -tolerance) return std::nullopt;
    const Real time = beyond <= tolerance ? Real(0) : Real(beyond / inwards);
    const Real steep = inwards * inwards / dot(normal, normal);
    const bool isTied = enter && abs(time - enter->time) <= sameTime();
    const bool isSide = sides[i].alongLine;
    const bool wasSide = enter && sides[enter->side.side].alongLine;
    if (!enter || (isTied ? isSide != wasSide ? isSide : steep < steepness : time > enter->time)) {
      enter = Hit{time, {ref.image, ref.obstacle, i}};
      steepness = steep;
    }
  }
  if (!enter) throw std::runtime_error("the body is inside an obstacle");
  if (leave && *leave - enter->time <= sameTime()) return std::nullopt;
  return enter;
}

std::optional<SolidPath::Hit> SolidPath::firstHit(const Way& way) const {
  std::optional<Hit> first;
  for (std::size_t image = 0; image < images_.size(); ++image) {
    for (std::size_t i = 0; i < images_[image].near.size(); ++i) {
      const auto hit = hitOf({image, i, 0}, way);
      if (hit && (!first || first->time - hit->time > sameTime())) first = hit;
    }
  }
  return first;
}

// Before that hit, the body may reach further faces.
std::optional<SolidPath::Hit> SolidPath::firstHitOnAnyFace(const Way& way) {
  if (way.time == 0) return std::nullopt;
  for (;;) {
    const auto hit = firstHit(way);
    const std::size_t known = images_.size();
    addReached((hit ? hit->time : way.time) * way.velocity);
    if (images_.size() == known) return hit;
  }
}

// The side that blocks the body: the side hit, or the adjacent one if the body is already at the end of that side.
SolidPath::SideRef SolidPath::blockingSide(SideRef hit) const {
  const Way way = wayAlong(hit);
  if (way.rests || way.time > 0) return hit;
  const RealVec wanted = turnedBy(images_[hit.image].rotation, velocity_);
  const RealVec normal = normalOf(side(hit));
  const bool ahead = normal.x * wanted.y > normal.y * wanted.x;
  return {hit.image, hit.obstacle, ahead ? side(hit).after : side(hit).before};
}

// Whether the side is that of an end that another segment reaches.
bool SolidPath::isAtJoint(SideRef ref) const {
  if (side(ref).alongLine) return false;
  const Image& own = images_[ref.image];
  const std::size_t line = own.lines[ref.obstacle];
  const oracle::Segment& ends = scene_->faces[own.face].lines[line];
  const RealVec normal = normalOf(side(ref));
  const Vec end = dot(normal, toReal(ends.a)) > dot(normal, toReal(ends.b)) ? ends.a : ends.b;
  const RealVec home = turnedBack(own.rotation, toReal(end) - own.shift);
  return std::any_of(images_.begin(), images_.end(), [&](const Image& image) {
    const bool isOwn = &image == &own;
    const std::int64_t reach = isOwn ? kJoint : kJointAcross;
    const Vec at = isOwn ? end : rounded(turnedBy(image.rotation, home) + image.shift);
    const auto square =
        oracle::OpenArea::placed({{-reach, -reach}, {reach, -reach}, {reach, reach}, {-reach, reach}}, at);
    const std::vector<oracle::Segment>& lines = scene_->faces[image.face].lines;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      if (!(isOwn && i == line) && square.intersects(lines[i])) return true;
    }
    return false;
  });
}

bool SolidPath::isFree(Vec place) const {
  return std::none_of(images_.begin(), images_.end(), [&](const Image& image) {
    const RealVec exact = turnedBy(image.rotation, toReal(place)) + image.shift;
    const RealVec at = &image == &images_.front() ? exact : toReal(rounded(exact));
    return std::any_of(image.near.begin(), image.near.end(), [&](const PathObstacle& obstacle) {
      return std::all_of(obstacle.sides.begin(), obstacle.sides.end(), [&](const Side& side) {
        return dot(normalOf(side), at) - toReal(side.bound) < -toleranceOf(side);
      });
    });
  });
}

bool SolidPath::isNarrow(std::int64_t distance) const {
  const Vec near = rounded(place_);
  for (std::int64_t x = -distance - 1; x <= distance + 1; ++x) {
    for (std::int64_t y = -distance - 1; y <= distance + 1; ++y) {
      const Vec place = near + Vec{x, y};
      const RealVec aside = toReal(place) - place_;
      if (dot(aside, aside) <= distance * distance && isFree(place)) return false;
    }
  }
  return true;
}

// Moves to the next contact, to the end of the way or to the end of the tick, or only turns at a contact. Returns false
// if the tick ends.
bool SolidPath::turn(Real& left) {
  Way way = contact_ ? wayAlong(*contact_) : Way{velocity_, left};
  const bool isSlow = contact_ && 1024 * dot(way.velocity, way.velocity) < dot(velocity_, velocity_);
  if (isSlow && isAtJoint(*contact_)) stoppedAtJoint_ = true;
  if (way.rests) return false;
  const bool endsFirst = way.time < left;
  if (!endsFirst) way.time = left;
  const auto hit = firstHitOnAnyFace(way);
  const bool moves = !hit || hit->time > sameTime();
  if (moves) {
    const Real time = hit ? hit->time : way.time;
    place_ = place_ + time * way.velocity;
    left -= time;
  }
  if (!hit) {
    contact_.reset();
    return endsFirst;
  }
  touched_ = true;
  const SideRef blocking = blockingSide(hit->side);
  if (contact_ && !moves) {
    Way onwards = wayAlong(blocking);
    if (onwards.rests) onwards.time = 1;
    const auto back = onwards.time > 0 ? hitOf(*contact_, onwards) : std::nullopt;
    if (back && back->time <= sameTime()) {
      stoppedAtJoint_ |= isAtJoint(blocking) || isAtJoint(*contact_);
      return false;
    }
  }
  contact_ = blocking;
  return true;
}

void SolidPath::tick(Vec velocity, std::int64_t heading) {
  velocity_ = turnedBy(directionOf(heading), toReal(velocity));
  touched_ = false;
  contact_.reset();
  if (velocity == Vec{}) return;
  images_.clear();
  addImage(0, face_, 0, {0, 0});
  Real left = 1;
  for (int turns = 0; left > 0 && turn(left); ++turns) {
    if (turns > kMaxTurnsOfTick) throw std::logic_error("the ideal path turns for ever at one place");
  }
}

}  // namespace platon::reference
