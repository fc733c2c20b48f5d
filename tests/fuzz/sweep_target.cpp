#include <algorithm>
#include <cstdlib>
#include <optional>

#include "platon/physics/convex.h"
#include "platon/physics/sweep.h"
#include "tests/exactness/oracle/sweep/sweep_oracle.h"
#include "tests/exactness/step_check/conversions.h"
#include "tests/fuzz/byte_source.h"
#include "tests/fuzz/fuzz_targets.h"

namespace platon::fuzz {
namespace {

using oracle::Polygon;
using oracle::SweepQuery;
using oracle::Vec;
using oracle::Wide;
using step_check::toPoint;
using step_check::toPoints;
using step_check::toSegment;
using step_check::toVec;

struct Ratio {
  Wide numerator = 0;
  Wide denominator = 1;

  // Numerators and denominators are below 2^63 in magnitude.
  friend bool operator<(Ratio a, Ratio b) { return a.numerator * b.denominator < b.numerator * a.denominator; }
  bool is(Fraction other) const { return numerator * other.denominator == other.numerator * denominator; }
};

/// Times at which the path enters and leaves the obstacle.
struct ClipInterval {
  Ratio enter;
  Ratio exit{1, 1};
};

// Clips the path against all sides of the obstacle, which are moved outwards by `margin` along each axis.
std::optional<ClipInterval> clipIntervalOf(const SweepQuery& query, std::int64_t margin) {
  ClipInterval interval;
  const Polygon polygon = oracle::obstacleOf(query);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec along = polygon[(i + 1) % polygon.size()] - polygon[i];
    const Vec outward{along.y, -along.x};
    const Wide moved = Wide{margin} * (std::abs(outward.x) + std::abs(outward.y));
    const Wide beyond = oracle::dot(outward, query.position - polygon[i]) - moved;
    const Wide speed = oracle::dot(outward, query.displacement);
    if (beyond >= 0 && speed >= 0) return std::nullopt;
    if (beyond >= 0) interval.enter = std::max(interval.enter, {beyond, -speed});
    if (beyond < 0 && speed > 0) interval.exit = std::min(interval.exit, {-beyond, speed});
  }
  return interval.enter < interval.exit ? std::optional(interval) : std::nullopt;
}

Polygon verticesFrom(ByteSource& bytes, std::int64_t radius) {
  std::vector<Vec> points(bytes.below(14) + 3);
  for (Vec& point : points) point = bytes.vector(radius);
  return points;
}

oracle::Segment segment(ByteSource& bytes, const Polygon& shape, std::int64_t radius) {
  const Vec a = bytes.vector(radius);
  const std::size_t edge = bytes.below(shape.size());
  const Vec along = shape[(edge + 1) % shape.size()] - shape[edge];
  switch (bytes.below(5)) {
    case 0:
      return {a, a};
    case 1:
      return {a, a + along};
    case 2:
      return {a, a - bytes.between(1, 3) * along};
    case 3:
      return {a, a + along + bytes.vector(1)};
    default:
      return {a, bytes.vector(radius)};
  }
}

// A point on or near a vertex or an edge of the obstacle, or a random one.
Vec place(ByteSource& bytes, const Polygon& obstacle, std::int64_t radius) {
  const std::size_t vertex = bytes.below(obstacle.size());
  const Vec here = obstacle[vertex];
  const Vec next = obstacle[(vertex + 1) % obstacle.size()];
  switch (bytes.below(5)) {
    case 0:
      return here + bytes.vector(1);
    case 1:
      return here + bytes.between(-3, 3) * (next - here);
    case 2:
      return {(here.x + next.x) / 2, (here.y + next.y) / 2};
    case 3:
      return here + bytes.vector(16);
    default:
      return bytes.vector(radius);
  }
}

SweepQuery queryFrom(ByteSource& bytes, const Polygon& shape, std::int64_t radius) {
  SweepQuery query{shape, {}, {}, segment(bytes, shape, radius)};
  const Polygon obstacle = oracle::obstacleOf(query);
  query.position = place(bytes, obstacle, radius);
  query.displacement = bytes.flag() ? bytes.vector(radius) : place(bytes, obstacle, radius) - query.position;
  return query;
}

std::string compared(const std::optional<Hit>& hit, const std::optional<ClipInterval>& interval) {
  if (hit.has_value() != interval.has_value()) return interval ? "missed hit" : "false hit";
  if (!hit) return {};
  if (hit->time.denominator <= 0 || !interval->enter.is(hit->time)) return "wrong time";
  if (hit->exit.denominator <= 0 || !interval->exit.is(hit->exit)) return "wrong exit";
  return {};
}

// A sweep with a margin must hit every segment that the Minkowski sum of shape and square hits. It may miss others near
// the tips of sharp vertices, which extend farther.
bool mayMiss(SweepQuery query, std::int64_t margin) {
  std::vector<Vec> points;
  for (const Vec vertex : query.shape) {
    for (const Vec corner : {Vec{margin, margin}, Vec{margin, -margin}, Vec{-margin, margin}, Vec{-margin, -margin}}) {
      points.push_back(vertex + corner);
    }
  }
  query.shape = oracle::convexHull(std::move(points));
  return !clipIntervalOf(query, 0);
}

std::string answerFault(const SweepQuery& query, const std::optional<Hit>& hit) {
  oracle::SweepAnswer answer;
  if (hit) answer = {true, hit->time.numerator, hit->time.denominator, toVec(hit->normal)};
  const oracle::CorrectAnswer correct = correctAnswer(query);
  return agrees(correct, answer) ? std::string() : "wrong answer; correct: " + toText(correct);
}

std::string described(const std::string& fault, const SweepQuery& query, std::int64_t margin) {
  if (fault.empty()) return {};
  return fault + ", margin " + std::to_string(margin) + ": " + toLine(query);
}

}  // namespace

std::string sweepFault(Bytes input) {
  ByteSource bytes(input);
  const std::int64_t radius = (std::int64_t{1} << bytes.between(1, 29)) - 1;
  Polygon shape = verticesFrom(bytes, radius);
  const bool convex = oracle::isStrictlyConvex(shape);
  if (Convex::fault(toPoints(shape)).has_value() == convex)
    return "wrong decision on whether a polygon is strictly convex";
  if (!convex) shape = oracle::convexHull(std::move(shape));
  if (shape.size() < 3) return {};
  const SweepQuery query = queryFrom(bytes, shape, radius);
  if (!isValid(query)) return {};
  const Convex figure(toPoints(shape));
  for (const std::int32_t margin : {0, static_cast<std::int32_t>(bytes.between(1, 16))}) {
    Sweep sweep;
    sweep.start(figure, toPoint(query.position), toPoint(query.displacement), margin);
    const auto hit = sweep.against(toSegment(query.segment));
    auto interval = clipIntervalOf(query, margin);
    if (!hit && margin != 0 && mayMiss(query, margin)) interval.reset();
    std::string fault = compared(hit, interval);
    if (fault.empty() && margin == 0) fault = answerFault(query, hit);
    if (!fault.empty()) return described(fault, query, margin);
  }
  return {};
}

}  // namespace platon::fuzz
