#include "tests/exactness/oracle/sweep/sweep_oracle.h"

#include <algorithm>

namespace platon::oracle {
namespace {

/// Time at which the line of a path enters a convex polygon, and the normals of the edges entered.
struct Entry {
  Wide numerator = 0;
  Wide denominator = 1;
  std::vector<Vec> normals;
};

Vec outwardOf(const Polygon& polygon, std::size_t edge) {
  const Vec along = polygon[(edge + 1) % polygon.size()] - polygon[edge];
  return {along.y, -along.x};
}

/// Entry through the interior of the edge that starts at vertex `edge`.
Entry throughEdge(const Polygon& polygon, std::size_t edge, Vec position, Vec displacement) {
  const Vec along = polygon[(edge + 1) % polygon.size()] - polygon[edge];
  return {cross(along, polygon[edge] - position), cross(along, displacement), {outwardOf(polygon, edge)}};
}

/// Entry through a vertex: every adjacent edge that faces the path is a correct answer.
Entry throughVertex(const Polygon& polygon, std::size_t vertex, Vec position, Vec displacement) {
  Entry entry{dot(polygon[vertex] - position, displacement), dot(displacement, displacement), {}};
  for (const std::size_t edge : {(vertex + polygon.size() - 1) % polygon.size(), vertex}) {
    const Vec outward = outwardOf(polygon, edge);
    if (dot(outward, displacement) < 0) entry.normals.push_back(outward);
  }
  return entry;
}

/// Where the line of the path enters the open polygon; nothing if it misses or only touches it. In counter-clockwise
/// order, the vertices before the entry lie left of the path and those after it right.
std::optional<Entry> findEntry(const Polygon& polygon, Vec position, Vec displacement) {
  const std::size_t count = polygon.size();
  std::vector<int> side(count);
  for (std::size_t i = 0; i < count; ++i) side[i] = sign(cross(displacement, polygon[i] - position));
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t next = (i + 1) % count;
    if (side[i] > 0 && side[next] < 0) return throughEdge(polygon, i, position, displacement);
    if (side[i] > 0 && side[next] == 0 && side[(i + 2) % count] < 0)
      return throughVertex(polygon, next, position, displacement);
  }
  return std::nullopt;
}

bool isInside(const Polygon& polygon, Vec point) {
  for (std::size_t i = 0; i < polygon.size(); ++i)
    if (cross(polygon[(i + 1) % polygon.size()] - polygon[i], point - polygon[i]) <= 0) return false;
  return true;
}

bool isPositiveMultiple(Vec a, Vec b) { return cross(a, b) == 0 && dot(a, b) > 0; }

std::string toText(Wide value) {
  std::string digits;
  for (Wide remaining = value < 0 ? -value : value; remaining != 0 || digits.empty(); remaining /= 10)
    digits.push_back(static_cast<char>('0' + static_cast<int>(remaining % 10)));
  if (value < 0) digits.push_back('-');
  return {digits.rbegin(), digits.rend()};
}

}  // namespace

Polygon obstacleOf(const SweepQuery& query) {
  std::vector<Vec> differences;
  differences.reserve(2 * query.shape.size());
  for (const Vec vertex : query.shape) {
    differences.push_back(query.segment.a - vertex);
    differences.push_back(query.segment.b - vertex);
  }
  return convexHull(std::move(differences));
}

CorrectAnswer correctAnswer(const SweepQuery& query) {
  using Kind = CorrectAnswer::Kind;
  const Polygon obstacle = obstacleOf(query);
  if (isInside(obstacle, query.position)) return {Kind::Overlap, 0, 1, {}};
  if (query.displacement == Vec{}) return {};
  std::optional<Entry> entry = findEntry(obstacle, query.position, query.displacement);
  if (!entry || entry->numerator < 0 || entry->numerator >= entry->denominator) return {};
  return {Kind::Hit, entry->numerator, entry->denominator, std::move(entry->normals)};
}

bool agrees(const CorrectAnswer& correct, const SweepAnswer& answer) {
  using Kind = CorrectAnswer::Kind;
  if (correct.kind == Kind::Miss || !answer.hit) return (correct.kind == Kind::Miss) == !answer.hit;
  if (correct.kind == Kind::Overlap) return answer.numerator == 0 && answer.denominator == 1 && answer.normal == Vec{};
  // All numerators and denominators are below 2^63, so the products are below 2^126.
  return answer.denominator > 0 && correct.numerator * answer.denominator == correct.denominator * answer.numerator &&
         std::any_of(correct.normals.begin(), correct.normals.end(),
                     [&](Vec outward) { return isPositiveMultiple(outward, answer.normal); });
}

std::string toText(const CorrectAnswer& correct) {
  if (correct.kind == CorrectAnswer::Kind::Miss) return "miss";
  if (correct.kind == CorrectAnswer::Kind::Overlap) return "hit 0 1 0 0";
  std::string text = "hit " + toText(correct.numerator) + " " + toText(correct.denominator);
  for (const Vec& outward : correct.normals)
    text += (&outward == &correct.normals.front() ? " " : " | ") + toText(outward.x) + " " + toText(outward.y);
  return text;
}

}  // namespace platon::oracle
