#include <gtest/gtest.h>

#include "tests/exactness/oracle/trace/sample_trace.h"

namespace platon::oracle::trace_header_test {
namespace {

using RuleNames = std::set<std::string>;

RuleNames rulesViolatedBy(const TraceHeader& header) { return violatedRules(std::vector<std::string>{toJson(header)}); }

const RuleNames kHeader{"header"};

const std::vector<std::vector<int>> kTetrahedron{{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
const std::vector<std::vector<int>> kOctahedron{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1},
                                                {5, 2, 1}, {5, 3, 2}, {5, 4, 3}, {5, 1, 4}};

TEST(TraceHeader, AcceptsCorrectHeaders) {
  EXPECT_EQ(rulesViolatedBy(sampleTrace().header), RuleNames{});
  EXPECT_EQ(rulesViolatedBy(makeHeader("TETRAHEDRON", kTetrahedron, 1000)), RuleNames{});
  EXPECT_EQ(rulesViolatedBy(makeHeader("OCTAHEDRON", kOctahedron, 65536)), RuleNames{});
}

TEST(TraceHeader, FacesMustBeThoseOfTheNamedSolid) {
  EXPECT_EQ(rulesViolatedBy(makeHeader("HEXAHEDRON", kTetrahedron, 1000)), kHeader);
  EXPECT_EQ(rulesViolatedBy(makeHeader("CUBE", kTetrahedron, 1000)), kHeader);
  EXPECT_EQ(rulesViolatedBy(makeHeader("PLANE", kTetrahedron, 1000)), kHeader);
}

TEST(TraceHeader, FaceSizesOutOfRangeAreRefused) {
  EXPECT_EQ(rulesViolatedBy(makeHeader("TETRAHEDRON", kTetrahedron, 199)), kHeader);
  EXPECT_EQ(rulesViolatedBy(makeHeader("TETRAHEDRON", kTetrahedron, 65537)), kHeader);
}

TEST(TraceHeader, IrregularFacesAreRefused) {
  TraceHeader header = sampleTrace().header;
  header.faces[4].polygon[2].x += 2;
  EXPECT_EQ(rulesViolatedBy(header), kHeader);
}

TEST(TraceHeader, EdgeZeroMustBeAtTheBottom) {
  TraceHeader header = makeHeader("TETRAHEDRON", kTetrahedron, 1000);
  for (Vec& corner : header.faces[1].polygon) corner = -corner;
  EXPECT_EQ(rulesViolatedBy(header), kHeader);
}

TEST(TraceHeader, TheShapeMustBeConvexAndCounterClockwise) {
  TraceHeader header = sampleTrace().header;
  std::swap(header.shape[0], header.shape[1]);
  EXPECT_EQ(rulesViolatedBy(header), kHeader);
}

TEST(TraceHeader, EveryEdgeMustHaveAWarp) {
  TraceHeader header = sampleTrace().header;
  header.faces[2].warps.pop_back();
  EXPECT_EQ(rulesViolatedBy(header), kHeader);
}

TEST(TraceHeader, NoEdgeMayHaveTwoWarps) {
  TraceHeader header = sampleTrace().header;
  header.faces[2].warps[1] = header.faces[2].warps[0];
  EXPECT_EQ(rulesViolatedBy(header), kHeader);
}

TEST(TraceHeader, EveryWarpMustHaveAReverseWarp) {
  TraceHeader header = sampleTrace().header;
  std::swap(header.faces[2].warps[1].to, header.faces[2].warps[2].to);
  std::swap(header.faces[2].warps[1].onto, header.faces[2].warps[2].onto);
  EXPECT_EQ(rulesViolatedBy(header), kHeader);
}

TEST(TraceHeader, WarpsMustMapEdgesToReversedEdges) {
  TraceHeader header = sampleTrace().header;
  std::swap(header.faces[2].warps[1].onto.a, header.faces[2].warps[1].onto.b);
  EXPECT_EQ(rulesViolatedBy(header), kHeader);
}

TEST(TraceHeader, FacesMustBeGluedAsOnTheSolid) {
  // Exchanges the warps of two edges: every warp still has a reverse warp, but the number of faces at some corners is
  // wrong.
  TraceHeader header = sampleTrace().header;
  TraceWarp& first = header.faces[0].warps[1];
  TraceWarp& second = header.faces[1].warps[1];
  const auto reverseOf = [&](const TraceWarp& warp) -> TraceWarp& {
    std::vector<TraceWarp>& warps = header.faces[static_cast<std::size_t>(warp.to)].warps;
    for (TraceWarp& candidate : warps)
      if (candidate.from == Segment{warp.onto.b, warp.onto.a}) return candidate;
    return warps.front();
  };
  TraceWarp& firstReverse = reverseOf(first);
  TraceWarp& secondReverse = reverseOf(second);
  std::swap(first.to, second.to);
  std::swap(first.onto, second.onto);
  std::swap(firstReverse.to, secondReverse.to);
  std::swap(firstReverse.onto, secondReverse.onto);
  EXPECT_EQ(rulesViolatedBy(header), kHeader);
}

TEST(TraceHeader, SegmentsMustLieInsideTheirFace) {
  TraceHeader header = sampleTrace().header;
  header.faces[3].lines.push_back({{0, 0}, {kSampleHalf, 100}});
  EXPECT_EQ(rulesViolatedBy(header), RuleNames{});
  header.faces[3].lines.push_back({{0, 0}, {kSampleHalf + 2, 100}});
  EXPECT_EQ(rulesViolatedBy(header), kHeader);
}

TEST(TraceHeader, EveryCornerMustBeBlocked) {
  TraceHeader header = sampleTrace().header;
  header.faces[5].lines.pop_back();
  EXPECT_EQ(rulesViolatedBy(header), kHeader);
}

TEST(TraceHeader, ASegmentAcrossACornerBlocksIt) {
  TraceHeader header = sampleTrace().header;
  const Vec corner = header.faces[5].polygon[3];
  ASSERT_EQ(corner, (Vec{-kSampleHalf, kSampleHalf}));
  header.faces[5].lines[3] = {corner + Vec{32, 0}, corner - Vec{0, 32}};
  EXPECT_EQ(rulesViolatedBy(header), RuleNames{});
  header.faces[5].lines[3] = {corner + Vec{32, -2}, corner - Vec{0, 32}};
  EXPECT_EQ(rulesViolatedBy(header), kHeader);
}

}  // namespace
}  // namespace platon::oracle::trace_header_test
