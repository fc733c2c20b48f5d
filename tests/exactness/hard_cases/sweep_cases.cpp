#include "tests/exactness/hard_cases/sweep_cases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "platon/physics/convex.h"
#include "platon/physics/sweep.h"
#include "tests/exactness/hard_cases/judged_world.h"
#include "tests/exactness/judge/conversions.h"
#include "tests/exactness/oracle/sweep/sweep_oracle.h"
#include "tests/exactness/oracle/sweep/sweep_query.h"

namespace platon::hard_cases {
namespace {

using oracle::SweepAnswer;
using oracle::SweepQuery;
using oracle::Vec;

constexpr int kSymmetries = 8;

oracle::SweepQuery parseQuery(const std::string& line) {
  std::istringstream in(line);
  SweepQuery query;
  std::size_t count = 0;
  in >> count;
  query.shape.resize(count);
  for (Vec& vertex : query.shape) in >> vertex.x >> vertex.y;
  for (Vec* v : {&query.position, &query.displacement, &query.obstacle.a, &query.obstacle.b}) in >> v->x >> v->y;
  if (!in || !isValid(query)) throw std::runtime_error("no query: " + line);
  return query;
}

// A mirroring first, then quarter turns.
Vec moved(Vec v, int symmetry) {
  if (symmetry >= kSymmetries / 2) v.x = -v.x;
  for (int quarter = symmetry % (kSymmetries / 2); quarter > 0; --quarter) v = {-v.y, v.x};
  return v;
}

SweepQuery moved(SweepQuery query, int symmetry) {
  for (Vec& vertex : query.shape) vertex = moved(vertex, symmetry);
  if (symmetry >= kSymmetries / 2) std::reverse(query.shape.begin(), query.shape.end());
  for (Vec* v : {&query.position, &query.displacement, &query.obstacle.a, &query.obstacle.b}) *v = moved(*v, symmetry);
  return query;
}

SweepAnswer answerOf(const SweepQuery& query) {
  const Convex shape(judge::toPoints(query.shape));
  Sweep sweep;
  sweep.start(shape, judge::toPoint(query.position), judge::toPoint(query.displacement));
  const auto hit = sweep.against(judge::toSegment(query.obstacle));
  if (!hit) return {};
  return {true, hit->time.numerator, hit->time.denominator, judge::toVec(hit->normal)};
}

void expectAnswer(const SweepQuery& query, const SweepAnswer& expected) {
  const oracle::SweepTruth truth = sweepTruth(query);
  EXPECT_TRUE(confirms(query, truth)) << toText(truth) << ": " << toLine(query);
  for (int symmetry = 0; symmetry < kSymmetries; ++symmetry) {
    const SweepQuery asked = moved(query, symmetry);
    const oracle::SweepTruth itsTruth = sweepTruth(asked);
    SweepAnswer movedAnswer = expected;
    movedAnswer.normal = moved(expected.normal, symmetry);
    EXPECT_TRUE(agrees(itsTruth, movedAnswer)) << "the file is wrong, " << toText(itsTruth) << ": " << toLine(asked);
    EXPECT_TRUE(agrees(itsTruth, answerOf(asked))) << "not " << toText(itsTruth) << ": " << toLine(asked);
  }
}

}  // namespace

std::size_t expectAnswers(const std::string& name) {
  std::istringstream queries(readCase(name + ".queries"));
  std::istringstream answers(readCase(name + ".answers"));
  std::string query;
  std::string answer;
  std::size_t count = 0;
  for (; std::getline(queries, query) && std::getline(answers, answer); ++count) {
    const auto expected = oracle::parseAnswer(answer);
    if (!expected) throw std::runtime_error("no answer: " + answer);
    SCOPED_TRACE(name + ", line " + std::to_string(count + 1));
    expectAnswer(parseQuery(query), *expected);
  }
  EXPECT_TRUE(queries.eof() && !std::getline(answers, answer)) << name << ": as many answers as queries";
  return count;
}

}  // namespace platon::hard_cases
