#include "tests/exactness/reference/solid_walk.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "platon/game/stage.h"
#include "platon/physics/entity.h"
#include "platon/physics/map_part.h"
#include "platon/physics/world.h"
#include "shared/game/face_area.h"
#include "tests/exactness/oracle/random_source.h"
#include "tests/exactness/reference/solid_path.h"
#include "tests/exactness/reference/terrain_judge.h"
#include "tests/exactness/step_check/conversions.h"
#include "tests/shared/game/real_face.h"

namespace platon::reference {
namespace {

using oracle::RandomSource;
using step_check::toPoint;
using step_check::toVec;

constexpr std::int32_t kFaceSize = 60;
/// Subunits between the two ideal bodies.
constexpr double kTwin = 1.0 / 64;
constexpr double kOne = static_cast<double>(PrecisePoint::kOne);

platon::Real toPlane(oracle::Vec v) { return {static_cast<double>(v.x), static_cast<double>(v.y)}; }

FinePoint fine(platon::Real point) {
  const Point at = nearest(point);
  return {std::int64_t{at.x} * FinePoint::kPerSubunit, std::int64_t{at.y} * FinePoint::kPerSubunit};
}

/// Makes a solid with random walls.
class StageMaker {
 public:
  StageMaker(SolidKind kind, RandomSource& random)
      : kind_(kind),
        solid_(PlatonicSolid::of(kind)),
        face_(kind, kFaceSize),
        area_(facePolygon(kind, kFaceSize)),
        random_(random),
        lines_(static_cast<std::size_t>(solid_.faces())) {}

  World make() {
    for (int face = 0; face < solid_.faces(); ++face) {
      for (int i = 0; i < 2; ++i) add(face, inside(1), inside(1));
      for (int edge = 0; edge < solid_.edgesPerFace(); ++edge) {
        if (random_.oneIn(2)) addFloor(face, edge);
        if (random_.oneIn(3)) addBeside(face, edge);
      }
    }
    return buildStage(kind_, kFaceSize, lines_);
  }

  platon::Real inside(double share) {
    const auto reach = static_cast<std::int64_t>(share * face_.inradius());
    return toPlane(random_.vector(reach));
  }

 private:
  void add(int face, platon::Real a, platon::Real b) {
    if (const auto clipped = area_.clip(fine(a), fine(b))) lines_[static_cast<std::size_t>(face)].push_back(*clipped);
  }

  platon::Real onEdge(int edge) { return face_.onEdge(edge, static_cast<double>(random_.between(15, 85)) / 100); }
  platon::Real loose(platon::Real end) { return random_.oneIn(2) ? end : end + toPlane(random_.vector(2)); }

  /// A wall that continues over an edge, straight on or with a bend.
  void addFloor(int face, int edge) {
    const PlatonicSolid::Neighbour& behind = solid_.neighbour(face, edge);
    const platon::Real end = onEdge(edge);
    const platon::Real start = inside(1);
    const platon::Real bend = random_.oneIn(2) ? platon::Real{} : toPlane(random_.vector(8000));
    add(face, start, loose(end));
    add(behind.face, face_.over(face, edge, end + 0.7 * (end - start) + bend), loose(face_.over(face, edge, end)));
  }

  /// A short wall that ends at, before or just beside an edge.
  void addBeside(int face, int edge) {
    const platon::Real end = onEdge(edge) - static_cast<double>(random_.between(0, 300)) * face_.outwards(edge);
    add(face, end, end + toPlane(random_.vector(9000)));
  }

  SolidKind kind_;
  const PlatonicSolid& solid_;
  RealFace face_;
  FaceArea area_;
  RandomSource& random_;
  std::vector<std::vector<Segment>> lines_;
};

SolidScene sceneOf(const Geometry& geometry, const Convex& shape, SolidKind kind) {
  SolidScene scene;
  const auto toReal = [](PrecisePoint point) {
    return RealVec{Real(static_cast<long>(point.x)) >> PrecisePoint::kBits,
                   Real(static_cast<long>(point.y)) >> PrecisePoint::kBits};
  };
  for (const auto& part : geometry.parts) {
    SolidFace& face = scene.faces.emplace_back();
    for (std::uint32_t i = 0; i < part->segments.size(); ++i) {
      if (!part->isWarp(i)) face.lines.push_back({toVec(part->segments[i].a), toVec(part->segments[i].b)});
    }
    for (const Warp& warp : part->warps) {
      face.warps.push_back({{toVec(warp.from.a), toVec(warp.from.b)},
                            warp.target,
                            warp.turn.centidegrees(),
                            toReal(warp.fromMiddle),
                            toReal(warp.ontoMiddle)});
    }
  }
  const std::int32_t step = Angle::kTurn / (2 * PlatonicSolid::of(kind).edgesPerFace());
  for (std::int32_t turn = 0; turn < Angle::kTurn; turn += step) {
    oracle::Polygon& polygon = scene.shapes[turn];
    const auto turned = shape.turned(Angle(turn));
    for (const Point vertex : turned.value().vertices()) polygon.push_back(toVec(vertex));
  }
  return scene;
}

Convex randomShape(RandomSource& random) {
  const auto corners = static_cast<int>(random.between(5, 12));
  const auto radius = static_cast<double>(random.between(1500, 6000));
  std::vector<Point> vertices;
  for (int i = 0; i < corners; ++i) {
    const Angle at(Angle::kTurn / corners * i + static_cast<std::int32_t>(random.between(0, 1500)));
    vertices.push_back(nearest(turned({radius, 0}, at)));
  }
  return Convex(convexHull(vertices));
}

/// Records the faces on which the body is at home, in order.
class HomeRecorder : public StepObserver {
 public:
  void leg(std::uint32_t, std::span<const InstanceView> instances) override {
    if (homes.empty() || homes.back() != instances[0].part) homes.push_back(instances[0].part);
    count = instances.size();
  }

  std::vector<std::uint32_t> homes;
  std::size_t count = 0;
};

class Walk {
 public:
  Walk(SolidKind kind, Drive drive, std::uint64_t seed)
      : random_(seed), drive_(drive), shape_(randomShape(random_)), maker_(kind, random_), world_(maker_.make()) {
    const Point start = insert();
    scene_ = sceneOf(world_.geometry(), shape_, kind);
    ideal_.emplace(scene_, world_.entities()[0].part, toVec(start));
    for (std::size_t i = 0; i < scene_.faces.size(); ++i) falls_.push_back(push(400, 900));
  }

  WalkVerdict judge(std::int64_t ticks) {
    for (std::int64_t tick = 1; tick <= ticks && verdict_.end == WalkEnd::kTicks; ++tick) {
      step();
      if (ideal_->wasStoppedAtJoint()) verdict_.end = WalkEnd::kJoint;
      if (isTied()) verdict_.end = WalkEnd::kTie;
      if (verdict_.end == WalkEnd::kTicks) compare();
    }
    return verdict_;
  }

 private:
  Point insert() {
    Entity entity(world_, shape_);
    for (;;) {
      const Point start = nearest(maker_.inside(0.7));
      try {
        MapPart(world_, 0).insert(entity, start, Angle());
        return start;
      } catch (const std::invalid_argument&) {  // not free
      }
    }
  }

  Point push(std::int64_t least, std::int64_t most) {
    const auto speed = static_cast<double>(random_.between(least, most));
    return nearest(turned({speed, 0}, Angle(static_cast<std::int32_t>(random_.between(0, Angle::kTurn - 1)))));
  }

  void choose() {
    Entity entity(world_, 0);
    if (drive_ == Drive::kPush) {
      if (left_-- > 0) return;
      left_ = random_.between(20, 80);
      given_ = push(100, random_.oneIn(8) ? 20000 : 1500);
    } else {
      if (left_-- <= 0) {
        left_ = random_.between(20, 80);
        walk_ = static_cast<std::int32_t>(random_.between(-900, 900));
      }
      const Point fall = falls_[entity.part()];
      given_ = fall + nearest(static_cast<double>(walk_) / length(real(fall)) * left(real(fall)));
    }
    entity.setVelocity(given_);
    givenAt_ = ideal_->turned();
  }

  void step() {
    choose();
    moveTwin();
    ideal_->tick(toVec(given_), ideal_->turned() - givenAt_);
    narrow_ = ideal_->isNarrow(static_cast<std::int64_t>(kMaxLatticeError));
    HomeRecorder homes;
    world_.solve(&homes);
    for (std::size_t i = 1; i < homes.homes.size(); ++i) {
      ideal_->changeFrame(homes.homes[i]);
      if (twin_) twin_->changeFrame(homes.homes[i]);
    }
    verdict_.crossings += static_cast<std::int64_t>(homes.homes.size()) - 1;
    instances_ = homes.count;
  }

  // The second ideal body. Where it has come back to the first one, it starts again beside it, if it is free there.
  void moveTwin() {
    if (!twin_ || separation() < kTwin / 4) {
      twin_.emplace(*ideal_);
      const platon::Real aside = turned({kTwin, 0}, Angle(static_cast<std::int32_t>(random_.between(0, 35999))));
      twin_->displace({Real(aside.x), Real(aside.y)});
    }
    try {
      twin_->tick(toVec(given_), ideal_->turned() - givenAt_);
    } catch (const std::runtime_error&) {
      twin_.reset();
    }
  }

  double separation() const {
    return std::hypot(Real(twin_->place().x - ideal_->place().x).get_d(),
                      Real(twin_->place().y - ideal_->place().y).get_d());
  }
  bool isTied() const { return twin_ && separation() > kMaxLatticeError; }

  void compare() {
    const EntityState& state = world_.entities()[0];
    const double x = Real(ideal_->place().x - state.position.x).get_d();
    const double y = Real(ideal_->place().y - state.position.y).get_d();
    const double precise = std::hypot(x - state.remainder.x / kOne, y - state.remainder.y / kOne);
    if (narrow_ && precise > kMaxLatticeError) {
      verdict_.end = WalkEnd::kNarrow;
      return;
    }
    double& worst = narrow_ ? verdict_.maxNarrow : instances_ > 1 ? verdict_.maxOverEdges : verdict_.maxLattice;
    worst = std::max(worst, std::hypot(x, y));
    verdict_.maxPrecise = std::max(verdict_.maxPrecise, precise);
    ++verdict_.judgedTicks;
    verdict_.narrowTicks += narrow_ ? 1 : 0;
    verdict_.contactTicks += ideal_->touched() ? 1 : 0;
  }

  RandomSource random_;
  Drive drive_;
  Convex shape_;
  StageMaker maker_;
  World world_;
  SolidScene scene_;
  std::optional<SolidPath> ideal_;
  std::optional<SolidPath> twin_;
  std::vector<Point> falls_;  // of each face
  Point given_;               // the last velocity that was set
  std::int64_t givenAt_ = 0;  // and how far frames had turned then
  std::int64_t left_ = 0;     // ticks until the next choice
  std::int32_t walk_ = 0;
  bool narrow_ = false;        // in this tick
  std::size_t instances_ = 0;  // after it
  WalkVerdict verdict_;
};

}  // namespace

WalkVerdict judgeWalk(SolidKind kind, Drive drive, std::uint64_t seed, std::int64_t ticks) {
  setRealPrecision();
  return Walk(kind, drive, seed).judge(ticks);
}

bool judgeWalks(std::uint64_t firstSeed, std::int64_t count, std::int64_t ticks, std::FILE* out) {
  bool holds = true;
  std::fprintf(out, "%-12s %-7s %5s %6s %8s %9s %6s %9s %10s %10s %11s %s\n", "solid", "drive", "seed", "judged",
               "contacts", "crossings", "narrow", "on a face", "over edges", "if narrow", "precise", "end");
  for (const SolidKind kind : kAllSolids) {
    for (const Drive drive : {Drive::kPush, Drive::kGravity}) {
      for (std::int64_t i = 0; i < count; ++i) {
        const std::uint64_t seed = firstSeed + static_cast<std::uint64_t>(i);
        const WalkVerdict walk = judgeWalk(kind, drive, seed, ticks);
        holds &= walk.holds();
        constexpr std::array<const char*, 4> kEnds = {"", "joint", "tie", "narrow"};
        std::fprintf(out, "%-12s %-7s %5llu %6lld %8lld %9lld %6lld %9.3f %10.3f %10.3f %11.8f %s\n",
                     std::string(nameOf(kind)).c_str(), drive == Drive::kPush ? "push" : "gravity",
                     static_cast<unsigned long long>(seed), static_cast<long long>(walk.judgedTicks),
                     static_cast<long long>(walk.contactTicks), static_cast<long long>(walk.crossings),
                     static_cast<long long>(walk.narrowTicks), walk.maxLattice, walk.maxOverEdges, walk.maxNarrow,
                     walk.maxPrecise, kEnds[static_cast<std::size_t>(walk.end)]);
      }
    }
  }
  return holds;
}

}  // namespace platon::reference
