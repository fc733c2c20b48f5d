// The same algorithm in floating point: swept Minkowski sum, the same grid, and slides along the edge hit up to its
// end. It keeps a slop between mover and segments; without one it falls through at the first rounding. It does not
// nudge.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <type_traits>
#include <vector>

#include "platon/exact/integer.h"
#include "platon/physics/grid.h"
#include "tests/bench/engine.h"
#include "tests/bench/float_sweep.h"

namespace platon::bench {
namespace {

constexpr int kMaxLegs = 16;
// Level units; many times the rounding error of a coordinate of a few thousand units.
template <class Real>
constexpr double kSlop = std::is_same_v<Real, float> ? 1.0 / 256 : 1.0 / (1 << 20);

template <class Real>
class FloatEngine : public Engine {
 public:
  explicit FloatEngine(const Scene& scene)
      : lines_(scene.lines),
        grid_(lines_),
        shape_(scene.shape),
        bounds_(scene.shape.bounds()),
        slop_(static_cast<Real>(kSlop<Real> * scene.subunitsPerUnit)) {
    for (const Point mover : scene.movers) movers_.push_back({toFloat<Real>(mover), {}, kNowhere, {}});
  }

  void setVelocity(std::size_t mover, Place velocity) override {
    movers_[mover].velocity = {static_cast<Real>(velocity.x), static_cast<Real>(velocity.y)};
  }
  void step() override {
    for (Mover& mover : movers_) move(mover);
  }
  Place position(std::size_t mover) const override {
    return {static_cast<double>(movers_[mover].position.x), static_cast<double>(movers_[mover].position.y)};
  }

 private:
  using Vector = FloatVector<Real>;
  using Edge = FloatEdge<Real>;

  static constexpr Box kNowhere{{1, 1}, {0, 0}};

  struct Mover {
    Vector position;
    Vector velocity;
    Box covered;  // area whose segments are in `near`
    std::vector<std::uint32_t> near;
  };
  // A hit, moved forward in time so that the slop remains.
  struct Stop {
    Real time;  // part of the displacement
    Edge edge;  // its normal has length one
  };
  // A slide along an edge up to its end. It uses `share` of the remaining displacement.
  struct Slide {
    Vector displacement;
    Real share;
  };

  static std::int32_t clamped(Real value) {
    constexpr auto kMax = static_cast<Real>(kCoordinateLimit);
    return static_cast<std::int32_t>(std::clamp(value, -kMax, kMax));
  }
  static Vector alongEdge(const Edge& edge) { return {-edge.normal.y, edge.normal.x}; }

  Box boundsAt(Vector place) const {
    return {{clamped(static_cast<Real>(bounds_.low.x) + place.x - 2),
             clamped(static_cast<Real>(bounds_.low.y) + place.y - 2)},
            {clamped(static_cast<Real>(bounds_.high.x) + place.x + 2),
             clamped(static_cast<Real>(bounds_.high.y) + place.y + 2)}};
  }
  void cover(Mover& mover, Vector to) {
    const Box start = boundsAt(mover.position);
    const Box end = boundsAt(to);
    const Box way{{std::min(start.low.x, end.low.x), std::min(start.low.y, end.low.y)},
                  {std::max(start.high.x, end.high.x), std::max(start.high.y, end.high.y)}};
    if (mover.covered.contains(way)) return;
    mover.covered = way.grown(std::max(way.high.x - way.low.x, way.high.y - way.low.y) / 2);
    mover.near.clear();
    grid_.query(mover.covered, mover.near);
  }

  // Sweeps a few slops farther than the displacement, so that the slop remains wherever the displacement ends.
  std::optional<Stop> first(Mover& mover, Vector way) {
    constexpr Real kAhead = 4;
    const Real all = length(way);
    if (all == 0) return std::nullopt;
    const Real farther = 1 + kAhead * slop_ / all;
    cover(mover, mover.position + way * farther);
    FloatSweep<Real> sweep(shape_, mover.position, way * farther);
    std::optional<Stop> best;
    for (const std::uint32_t index : mover.near) {
      const Vector a = toFloat<Real>(lines_[index].a);
      const Vector b = toFloat<Real>(lines_[index].b);
      const auto time = sweep.against(a, b);
      if (!time) continue;
      Edge edge = sweep.edge(a, b);
      edge.normal = edge.normal * (1 / length(edge.normal));
      const Real approach = -dot(way, edge.normal);
      if (approach <= 0) continue;  // overlaps already and moves out
      const Real early = std::max<Real>(0, *time * farther - slop_ / approach);
      if (early < (best ? best->time : Real{1})) best = Stop{early, edge};
    }
    return best;
  }

  Slide slide(Vector position, Vector remaining, const Edge& edge) const {
    const Vector tangent = alongEdge(edge);
    const Real along = dot(remaining, tangent);
    if (along == 0) return {{}, 1};
    const Real reach = along > 0 ? dot(edge.to - position, tangent) : dot(position - edge.from, tangent);
    // At the end already, and hit again: rounding hides which of the two edges it is.
    const Real share = reach > 0 ? std::min<Real>((reach + slop_) / std::abs(along), 1) : 1;
    return {tangent * (along * share), share};
  }

  void move(Mover& mover) {
    Vector remaining = mover.velocity;
    std::optional<Edge> held;
    for (int leg = 0; leg < kMaxLegs && dot(remaining, remaining) > 0; ++leg) {
      const Slide next = held ? slide(mover.position, remaining, *held) : Slide{remaining, 1};
      const auto stop = first(mover, next.displacement);
      const Real time = stop ? stop->time : 1;
      mover.position = mover.position + next.displacement * time;
      remaining = remaining * (1 - time * next.share);
      const bool wedged =
          held && stop && dot(slide(mover.position, remaining, stop->edge).displacement, held->normal) < 0;
      if (wedged) return;
      held = stop ? std::optional(stop->edge) : std::nullopt;
    }
  }

  std::vector<Segment> lines_;
  Grid grid_;
  FloatShape<Real> shape_;
  Box bounds_;
  Real slop_;  // subunits
  std::vector<Mover> movers_;
};

}  // namespace

std::unique_ptr<Engine> makeFloat32(const Scene& scene) { return std::make_unique<FloatEngine<float>>(scene); }
std::unique_ptr<Engine> makeFloat64(const Scene& scene) { return std::make_unique<FloatEngine<double>>(scene); }

}  // namespace platon::bench
