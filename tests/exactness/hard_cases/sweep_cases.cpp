#include "tests/exactness/hard_cases/sweep_cases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "platon/physics/convex.h"
#include "platon/physics/sweep.h"
#include "tests/exactness/hard_cases/checked_world.h"
#include "tests/exactness/oracle/sweep/sweep_oracle.h"
#include "tests/exactness/oracle/sweep/sweep_query.h"
#include "tests/exactness/step_check/conversions.h"

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
  for (Vec* v : {&query.position, &query.displacement, &query.segment.a, &query.segment.b}) in >> v->x >> v->y;
  if (!in || !isValid(query)) throw std::runtime_error("not a query: " + line);
  return query;
}

// Mirrors if the symmetry says so, then rotates by quarter turns.
Vec transformed(Vec v, int symmetry) {
  if (symmetry >= kSymmetries / 2) v.x = -v.x;
  for (int quarter = symmetry % (kSymmetries / 2); quarter > 0; --quarter) v = {-v.y, v.x};
  return v;
}

SweepQuery transformed(SweepQuery query, int symmetry) {
  for (Vec& vertex : query.shape) vertex = transformed(vertex, symmetry);
  if (symmetry >= kSymmetries / 2) std::reverse(query.shape.begin(), query.shape.end());
  for (Vec* v : {&query.position, &query.displacement, &query.segment.a, &query.segment.b})
    *v = transformed(*v, symmetry);
  return query;
}

SweepAnswer answerOf(const SweepQuery& query) {
  const Convex shape(step_check::toPoints(query.shape));
  Sweep sweep;
  sweep.start(shape, step_check::toPoint(query.position), step_check::toPoint(query.displacement));
  const auto hit = sweep.against(step_check::toSegment(query.segment));
  if (!hit) return {};
  return {true, hit->time.numerator, hit->time.denominator, step_check::toVec(hit->normal)};
}

void expectAnswer(const SweepQuery& query, const SweepAnswer& expected) {
  const oracle::CorrectAnswer correct = correctAnswer(query);
  EXPECT_TRUE(confirms(query, correct)) << toText(correct) << ": " << toLine(query);
  for (int symmetry = 0; symmetry < kSymmetries; ++symmetry) {
    const SweepQuery symmetricQuery = transformed(query, symmetry);
    const oracle::CorrectAnswer symmetricCorrect = correctAnswer(symmetricQuery);
    SweepAnswer symmetricAnswer = expected;
    symmetricAnswer.normal = transformed(expected.normal, symmetry);
    EXPECT_TRUE(agrees(symmetricCorrect, symmetricAnswer))
        << "wrong answer in the file; correct: " << toText(symmetricCorrect) << ": " << toLine(symmetricQuery);
    EXPECT_TRUE(agrees(symmetricCorrect, answerOf(symmetricQuery)))
        << "wrong answer of Sweep; correct: " << toText(symmetricCorrect) << ": " << toLine(symmetricQuery);
  }
}

}  // namespace

std::size_t expectAnswers(const std::string& name) {
  std::istringstream queries(readSceneFile(name + ".queries"));
  std::istringstream answers(readSceneFile(name + ".answers"));
  std::string query;
  std::string answer;
  std::size_t count = 0;
  for (; std::getline(queries, query) && std::getline(answers, answer); ++count) {
    const auto expected = oracle::parseAnswer(answer);
    if (!expected) throw std::runtime_error("not an answer: " + answer);
    SCOPED_TRACE(name + ", line " + std::to_string(count + 1));
    expectAnswer(parseQuery(query), *expected);
  }
  EXPECT_TRUE(queries.eof() && !std::getline(answers, answer))
      << name << ": the number of answers differs from that of queries";
  return count;
}

}  // namespace platon::hard_cases
