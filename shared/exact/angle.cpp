#include "platon/exact/angle.h"

#include <array>
#include <cstddef>

#include "platon/exact/integer.h"

namespace platon {
namespace {

constexpr int kTableBits = 60;
constexpr std::int64_t kOne = std::int64_t{1} << kTableBits;
// pi / 18000 (one centidegree in radians) times 2^60, from pi = 3.14159265358979323846264338.
constexpr std::int64_t kCentidegree = 201222762724365;

constexpr std::int64_t multiply(std::int64_t a, std::int64_t b) {
  return static_cast<std::int64_t>((int128{a} * b) >> kTableBits);
}

// Taylor series of sine or cosine, 12 terms. For arguments up to a quarter turn the error is below 2^-60.
constexpr std::int64_t taylor(std::int64_t x, std::int64_t term, int firstDivisor) {
  std::int64_t sum = term;
  const std::int64_t square = multiply(x, x / 4);  // x^2 / 4, at most pi^2 / 16
  for (int n = firstDivisor; n < firstDivisor + 24; n += 2) {
    term = -4 * (multiply(term, square) / (n * (n + 1)));
    sum += term;
  }
  return sum;
}

constexpr Rotation rotationOfCentidegrees(std::int32_t centidegrees) {
  const std::int64_t x = kCentidegree * centidegrees;
  constexpr int shift = kTableBits - Rotation::kFractionBits;
  const std::int64_t half = std::int64_t{1} << (shift - 1);
  return {(taylor(x, kOne, 1) + half) >> shift, (taylor(x, x, 2) + half) >> shift};
}

template <std::size_t Count, std::int32_t Step>
constexpr std::array<Rotation, Count> makeTable() {
  std::array<Rotation, Count> table{};
  for (std::size_t i = 0; i < Count; ++i) {
    table[i] = rotationOfCentidegrees(static_cast<std::int32_t>(i) * Step);
  }
  return table;
}

// Tables of whole degrees and of centidegrees; the angle addition formulas combine them with one rounding.
constexpr auto kDegrees = makeTable<91, 100>();
constexpr auto kCentidegrees = makeTable<100, 1>();
static_assert(kDegrees[0].cosine == std::int64_t{1} << 30 && kDegrees[0].sine == 0);
static_assert(kDegrees[90].cosine == 0 && kDegrees[90].sine == std::int64_t{1} << 30);
static_assert(kDegrees[30].sine == std::int64_t{1} << 29 && kDegrees[60].cosine == std::int64_t{1} << 29);

constexpr std::int64_t roundToBits(std::int64_t value) { return shiftRounded<Rotation::kFractionBits>(value); }

Rotation firstQuadrant(std::int32_t centidegrees) {
  const Rotation whole = kDegrees[static_cast<std::size_t>(centidegrees / 100)];
  if (centidegrees % 100 == 0) return whole;
  const Rotation part = kCentidegrees[static_cast<std::size_t>(centidegrees % 100)];
  return {roundToBits(whole.cosine * part.cosine - whole.sine * part.sine),
          roundToBits(whole.sine * part.cosine + whole.cosine * part.sine)};
}

}  // namespace

Rotation rotationOf(Angle angle) {
  if (angle == Angle()) return Rotation::none();  // fast path: usually zero
  constexpr std::int32_t quarter = Angle::kTurn / 4;
  const Rotation base = firstQuadrant(angle.centidegrees() % quarter);
  switch (angle.centidegrees() / quarter) {
    case 0:
      return base;
    case 1:
      return {-base.sine, base.cosine};
    case 2:
      return {-base.cosine, -base.sine};
    default:
      return {base.sine, -base.cosine};
  }
}

Point rotate(Point vector, Angle angle) { return rotate(vector, rotationOf(angle)); }

Angle angleBetween(Point from, Point to) {
  // The cross product of the rotated `from` with `to` changes sign once in each half turn: bisects the half turn that
  // contains the angle, then returns the nearer of the two neighbouring centidegrees.
  const auto side = [&](std::int32_t centidegrees) {
    const WideVector turned = rotateWide(from, rotationOf(Angle(centidegrees)));
    return int128{turned.x} * to.y - int128{turned.y} * to.x;
  };
  constexpr std::int32_t half = Angle::kTurn / 2;
  const bool firstHalf = cross(from, to) > 0 || (cross(from, to) == 0 && dot(from, to) > 0);
  std::int32_t low = firstHalf ? 0 : half;
  std::int32_t high = low + half;
  while (high - low > 1) {
    const std::int32_t middle = (low + high) / 2;
    (side(middle) >= 0 ? low : high) = middle;
  }
  const int128 below = side(low);
  const int128 above = -side(high);
  return Angle(above < below ? high : low);
}

}  // namespace platon
