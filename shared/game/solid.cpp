#include "platon/game/solid.h"

#include "platon/exact/integer.h"
#include "shared/exact/square_root.h"

namespace platon {
namespace {

// Vertices at the corners of every face, in order of faces and corners. All neighbours are computed from them.
constexpr std::uint8_t kTetrahedronCorners[] = {0, 1, 3, 1, 2, 3, 2, 0, 3, 1, 0, 2};

constexpr std::uint8_t kHexahedronCorners[] = {0, 1, 5, 4, 1, 2, 6, 5, 2, 3, 7, 6, 3, 0, 4, 7, 4, 5, 6, 7, 3, 2, 1, 0};

constexpr std::uint8_t kOctahedronCorners[] = {0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4, 1, 0, 5, 2, 1, 5, 3, 2, 5, 0, 3, 5};

constexpr std::uint8_t kDodecahedronCorners[] = {1,  0,  4,  3,  2,  0,  1,  6,  10, 5,  1,  2,  7,  11, 6,
                                                 2,  3,  8,  12, 7,  3,  4,  9,  13, 8,  4,  0,  5,  14, 9,
                                                 16, 15, 10, 6,  11, 17, 16, 11, 7,  12, 18, 17, 12, 8,  13,
                                                 19, 18, 13, 9,  14, 15, 19, 14, 5,  10, 15, 16, 17, 18, 19};

constexpr std::uint8_t kIcosahedronCorners[] = {2, 1, 0, 3,  2, 0, 4, 3,  0, 5,  4,  0, 1, 5,  0, 1,  2,  6,  2, 3,
                                                7, 3, 4, 8,  4, 5, 9, 5,  1, 10, 7,  6, 2, 8,  7, 3,  9,  8,  4, 10,
                                                9, 5, 6, 10, 1, 6, 7, 11, 7, 8,  11, 8, 9, 11, 9, 10, 11, 10, 6, 11};

}  // namespace

constexpr PlatonicSolid::PlatonicSolid(SolidKind kind, int edgesPerFace, std::span<const std::uint8_t> vertices)
    : kind_(kind), edgesPerFace_(edgesPerFace), faces_(static_cast<int>(vertices.size()) / edgesPerFace) {
  for (std::size_t i = 0; i < vertices.size(); ++i) vertices_[i] = vertices[i];
  for (int face = 0; face < faces_; ++face) {
    for (int edge = 0; edge < edgesPerFace_; ++edge) neighbours_[indexOf(face, edge)] = findNeighbour(face, edge);
  }
}

// Edge i of a face has the direction i * 360° / edges. The shared edge has the opposite direction in the neighbour.
constexpr PlatonicSolid::Neighbour PlatonicSolid::findNeighbour(int face, int edge) const {
  const auto corner = [this](int of, int at) { return vertices_[indexOf(of, at % edgesPerFace_)]; };
  for (int other = 0; other < faces_; ++other) {
    for (int back = 0; back < edgesPerFace_; ++back) {
      if (corner(other, back) != corner(face, edge + 1) || corner(other, back + 1) != corner(face, edge)) continue;
      const int turn = (back - edge) * (Angle::kTurn / edgesPerFace_) + Angle::kTurn / 2;
      return {static_cast<std::uint8_t>(other), static_cast<std::uint8_t>(back), Angle(turn)};
    }
  }
  return {};
}

const PlatonicSolid& PlatonicSolid::of(SolidKind kind) {
  static constexpr std::array<PlatonicSolid, kSolidKinds> solids = {
      PlatonicSolid(SolidKind::kTetrahedron, 3, kTetrahedronCorners),
      PlatonicSolid(SolidKind::kHexahedron, 4, kHexahedronCorners),
      PlatonicSolid(SolidKind::kOctahedron, 3, kOctahedronCorners),
      PlatonicSolid(SolidKind::kDodecahedron, 5, kDodecahedronCorners),
      PlatonicSolid(SolidKind::kIcosahedron, 3, kIcosahedronCorners)};
  return solids[static_cast<std::size_t>(kind)];
}

std::string_view nameOf(SolidKind kind) {
  static constexpr std::array<std::string_view, kSolidKinds> names = {"TETRAHEDRON", "HEXAHEDRON", "OCTAHEDRON",
                                                                      "DODECAHEDRON", "ICOSAHEDRON"};
  return names[static_cast<std::size_t>(kind)];
}

namespace {

// The number sqrt((whole + fives * sqrt(5)) / divisor). Every coordinate of a regular triangle, square or pentagon with
// edge 1 is 0, such a number, or its negative.
struct Surd {
  int whole;
  int fives;
  int divisor;
};

constexpr Surd kHalf{1, 0, 4};
constexpr Surd kTriangleInradius{1, 0, 12};
constexpr Surd kTriangleCircumradius{1, 0, 3};
constexpr Surd kPentagonInradius{5, 2, 20};
constexpr Surd kPentagonCircumradius{5, 1, 10};
constexpr Surd kPentagonHalfDiagonal{6, 2, 16};
constexpr Surd kPentagonShoulder{5, -1, 40};  // height of the two outermost corners above the centre

// `edge` * `surd`, rounded to the nearest integer. Exact for edges up to 2^26: 4 * edge^2 < 2^55, and its square times
// 5 * fives^2 is below 2^115. Rounding down before the division and before the outer root does not change their
// rounded-down results. There are no ties: `edge` is even, and all the numbers but kHalf are irrational.
std::int32_t nearest(std::int64_t edge, Surd surd) {
  const int128 square = int128{4} * edge * edge;
  const int128 fives = squareRootFloor(5 * square * square * surd.fives * surd.fives);
  const int128 sum = square * surd.whole + (surd.fives >= 0 ? fives : -fives - 1);
  return static_cast<std::int32_t>((squareRootFloor(sum / surd.divisor) + 1) / 2);
}

}  // namespace

std::vector<Point> facePolygon(SolidKind kind, std::int32_t faceSize) {
  const auto length = [edge = std::int64_t{faceSize} * kSubunitsPerUnit](Surd surd) { return nearest(edge, surd); };
  const std::int32_t half = length(kHalf);
  switch (PlatonicSolid::of(kind).edgesPerFace()) {
    case 3: {
      const std::int32_t below = length(kTriangleInradius);
      return {{-half, -below}, {half, -below}, {0, length(kTriangleCircumradius)}};
    }
    case 4:
      return {{-half, -half}, {half, -half}, {half, half}, {-half, half}};
    default: {
      const std::int32_t below = length(kPentagonInradius);
      const std::int32_t wide = length(kPentagonHalfDiagonal);
      const std::int32_t shoulder = length(kPentagonShoulder);
      return {{-half, -below}, {half, -below}, {wide, shoulder}, {0, length(kPentagonCircumradius)}, {-wide, shoulder}};
    }
  }
}

PrecisePoint edgeMiddle(SolidKind kind, std::int32_t faceSize, int edge) {
  // Radius of the inscribed circle of a face with edge 1, 1 / (2 tan(180° / edges)), times 2^62; by edges from 3.
  constexpr std::int64_t inradius[] = {1331279082078542925, 2305843009213693952, 3173720629326573981};
  const int edges = PlatonicSolid::of(kind).edgesPerFace();
  const int128 length = int128{faceSize} * kSubunitsPerUnit * PrecisePoint::kOne;  // < 2^53
  const auto radius = static_cast<std::int64_t>((length * inradius[edges - 3]) >> 62);
  const Rotation turn = rotationOf(Angle(Angle::kTurn / edges * edge));
  return rotated({0, -radius}, turn);
}

}  // namespace platon
