// The same algorithm in floating point: swept Minkowski sum, the same grid, and slides along the edge hit up to its
// end. It keeps a slop between body and segments; without one, the body would fall through a segment at the first
// rounding. It does not nudge.
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
#include "tests/bench/engines/engine.h"
#include "tests/bench/engines/falling_engine.h"
#include "tests/bench/engines/float_sweep.h"

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
      : lines_(scene.segments),
        grid_(lines_),
        shape_(scene.shape),
        bounds_(scene.shape.bounds()),
        slop_(static_cast<Real>(kSlop<Real> * scene.subunitsPerUnit)) {
    for (const Point body : scene.bodies) bodies_.push_back({toFloat<Real>(body), {}, kNowhere, {}});
  }

  void setVelocity(std::size_t body, Place velocity) override {
    bodies_[body].velocity = {static_cast<Real>(velocity.x), static_cast<Real>(velocity.y)};
  }
  void step() override {
    for (Body& body : bodies_) move(body);
  }
  Place position(std::size_t body) const override {
    return {static_cast<double>(bodies_[body].position.x), static_cast<double>(bodies_[body].position.y)};
  }

 private:
  using Vector = FloatVector<Real>;
  using Edge = FloatEdge<Real>;

  static constexpr Box kNowhere{{1, 1}, {0, 0}};

  struct Body {
    Vector position;
    Vector velocity;
    Box covered;  // area whose segments are in `near`
    std::vector<std::uint32_t> near;
  };
  // A hit, moved forward in time so that the slop remains.
  struct Stop {
    Real time;  // fraction of the displacement
    Edge edge;  // its normal has length one
  };
  // A slide along an edge up to its end. It uses `fraction` of the remaining displacement.
  struct Slide {
    Vector displacement;
    Real fraction;
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
  void cover(Body& body, Vector to) {
    const Box start = boundsAt(body.position);
    const Box end = boundsAt(to);
    const Box way{{std::min(start.low.x, end.low.x), std::min(start.low.y, end.low.y)},
                  {std::max(start.high.x, end.high.x), std::max(start.high.y, end.high.y)}};
    if (body.covered.contains(way)) return;
    body.covered = way.grown(std::max(way.high.x - way.low.x, way.high.y - way.low.y) / 2);
    body.near.clear();
    grid_.query(body.covered, body.near);
  }

  // Sweeps a few slops farther than the displacement, so that the slop remains wherever the displacement ends.
  std::optional<Stop> first(Body& body, Vector way) {
    constexpr Real kAhead = 4;
    const Real all = length(way);
    if (all == 0) return std::nullopt;
    const Real farther = 1 + kAhead * slop_ / all;
    cover(body, body.position + way * farther);
    FloatSweep<Real> sweep(shape_, body.position, way * farther);
    std::optional<Stop> best;
    for (const std::uint32_t index : body.near) {
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
    const Real fraction = reach > 0 ? std::min<Real>((reach + slop_) / std::abs(along), 1) : 1;
    return {tangent * (along * fraction), fraction};
  }

  void move(Body& body) {
    Vector remaining = body.velocity;
    std::optional<Edge> held;
    for (int leg = 0; leg < kMaxLegs && dot(remaining, remaining) > 0; ++leg) {
      const Slide next = held ? slide(body.position, remaining, *held) : Slide{remaining, 1};
      const auto stop = first(body, next.displacement);
      const Real time = stop ? stop->time : 1;
      body.position = body.position + next.displacement * time;
      remaining = remaining * (1 - time * next.fraction);
      const bool wedged =
          held && stop && dot(slide(body.position, remaining, stop->edge).displacement, held->normal) < 0;
      if (wedged) return;
      held = stop ? std::optional(stop->edge) : std::nullopt;
    }
  }

  std::vector<Segment> lines_;
  Grid grid_;
  FloatShape<Real> shape_;
  Box bounds_;
  Real slop_;  // subunits
  std::vector<Body> bodies_;
};

}  // namespace

std::unique_ptr<Engine> makeFloat32(const Scene& scene) {
  return withGravity(std::make_unique<FloatEngine<float>>(scene), scene);
}
std::unique_ptr<Engine> makeFloat64(const Scene& scene) {
  return withGravity(std::make_unique<FloatEngine<double>>(scene), scene);
}

}  // namespace platon::bench
