// The same algorithm in floating point, as one would write it without exactness: swept Minkowski sum, the lines out of
// the same grid, sliding along the edge that is met as far as that goes. It keeps a slop between mover and lines, for
// without one it falls through at the first rounding. It lacks what passes the ends of lines that stand out.
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
// Units: many times what a coordinate of a few thousand units is rounded by.
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
    Box covered;  // what `near` is for
    std::vector<std::uint32_t> near;
  };
  // A meeting, brought forward to where the slop is left.
  struct Stop {
    Real time;  // part of the way
    Edge edge;  // its normal has length one
  };
  // Along an edge, as far as it goes; `share` of the displacement takes it there.
  struct Slide {
    Vector way;
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

  // Looks a few slops ahead, so that the slop is left wherever the way ends.
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
      if (approach <= 0) continue;  // already overlapped, on the way out
      const Real early = std::max<Real>(0, *time * farther - slop_ / approach);
      if (early < (best ? best->time : Real{1})) best = Stop{early, edge};
    }
    return best;
  }

  Slide slide(Vector position, Vector rest, const Edge& edge) const {
    const Vector tangent = alongEdge(edge);
    const Real along = dot(rest, tangent);
    if (along == 0) return {{}, 1};
    const Real reach = along > 0 ? dot(edge.to - position, tangent) : dot(position - edge.from, tangent);
    // At the end already, and met again: rounding cannot tell this edge from the next.
    const Real share = reach > 0 ? std::min<Real>((reach + slop_) / std::abs(along), 1) : 1;
    return {tangent * (along * share), share};
  }

  void move(Mover& mover) {
    Vector rest = mover.velocity;
    std::optional<Edge> held;
    for (int leg = 0; leg < kMaxLegs && dot(rest, rest) > 0; ++leg) {
      const Slide next = held ? slide(mover.position, rest, *held) : Slide{rest, 1};
      const auto stop = first(mover, next.way);
      const Real time = stop ? stop->time : 1;
      mover.position = mover.position + next.way * time;
      rest = rest * (1 - time * next.share);
      const bool wedged = held && stop && dot(slide(mover.position, rest, stop->edge).way, held->normal) < 0;
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
