#include "tests/exactness/oracle/trace/solid_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace platon::oracle {
namespace {

constexpr long double kPi = std::numbers::pi_v<long double>;

constexpr std::array<SolidNumbers, 5> kSolids{{
    {"TETRAHEDRON", 4, 3, 3},
    {"HEXAHEDRON", 6, 4, 3},
    {"OCTAHEDRON", 8, 3, 4},
    {"DODECAHEDRON", 12, 5, 3},
    {"ICOSAHEDRON", 20, 3, 5},
}};

RealVec polar(long double radius, long double radians) {
  return {radius * std::cos(radians), radius * std::sin(radians)};
}

}  // namespace

std::int64_t normalizedAngle(std::int64_t centidegrees) { return (centidegrees % kTurn + kTurn) % kTurn; }

const SolidNumbers* findSolid(std::string_view name) {
  const auto solid =
      std::find_if(kSolids.begin(), kSolids.end(), [&](const SolidNumbers& s) { return s.name == name; });
  return solid == kSolids.end() ? nullptr : &*solid;
}

RealVec toReal(Vec v) { return {static_cast<long double>(v.x), static_cast<long double>(v.y)}; }

long double distance(RealVec a, RealVec b) { return std::hypot(a.x - b.x, a.y - b.y); }

RealVec idealCorner(std::size_t corners, long double edgeLength, std::size_t index) {
  const long double half = kPi / static_cast<long double>(corners);
  const long double radius = edgeLength / (2 * std::sin(half));
  return polar(radius, -kPi / 2 - half + 2 * half * static_cast<long double>(index));
}

RealVec idealEdgeMiddle(std::size_t corners, long double edgeLength, std::size_t index) {
  const long double half = kPi / static_cast<long double>(corners);
  const long double inradius = edgeLength / (2 * std::tan(half));
  return polar(inradius, -kPi / 2 + 2 * half * static_cast<long double>(index));
}

Isometry::Isometry(std::int64_t turn, RealVec from, RealVec onto)
    : turn_(normalizedAngle(turn)),
      cosine_(std::cos(kPi * static_cast<long double>(turn_) / (kTurn / 2))),
      sine_(std::sin(kPi * static_cast<long double>(turn_) / (kTurn / 2))) {
  const RealVec carried = turned(from);
  shift_ = {onto.x - carried.x, onto.y - carried.y};
}

RealVec Isometry::apply(RealVec point) const {
  const RealVec carried = turned(point);
  return {carried.x + shift_.x, carried.y + shift_.y};
}

RealVec Isometry::turned(RealVec displacement) const {
  return {cosine_ * displacement.x - sine_ * displacement.y, sine_ * displacement.x + cosine_ * displacement.y};
}

}  // namespace platon::oracle
