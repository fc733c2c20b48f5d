#include "tests/bench/sweep_bench.h"

#include <box2d/b2_time_of_impact.h>
#include <box2d/box2d.h>
#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "platon/exact/fraction.h"
#include "platon/physics/sweep.h"
#include "tests/bench/engines/float_sweep.h"
#include "tests/bench/overlap.h"
#include "tests/bench/sweep_sets.h"
#include "tests/exactness/oracle/sweep/sweep_oracle.h"

namespace platon::bench {
namespace {

constexpr std::size_t kQueries = 20000;

// Time of the hit, exactly as the engine reports it; nothing if it reports none.
using Answer = std::optional<mpq_class>;

__extension__ using Wide = __int128;

mpz_class integer(Wide value) {
  const mpz_class high(static_cast<long>(value >> 64));
  return (high << 64) + mpz_class(static_cast<unsigned long>(value));
}

mpq_class rational(Wide numerator, Wide denominator) {
  mpq_class fraction(integer(numerator), integer(denominator));
  fraction.canonicalize();
  return fraction;
}

mpq_class exactly(Fraction time) { return rational(time.numerator, time.denominator); }
mpq_class exactly(double time) { return mpq_class(time); }

class PlatonSweeps {
 public:
  explicit PlatonSweeps(const SweepSet& set) : set_(set) {}

  std::optional<Fraction> operator()(const SweepQuery& query) {
    sweep_.start(set_.shapes[query.shape], query.position, query.displacement);
    const auto hit = sweep_.against(query.segment);
    if (!hit) return std::nullopt;
    return hit->time;
  }

 private:
  const SweepSet& set_;
  Sweep sweep_;
};

template <class Real>
class FloatSweeps {
 public:
  explicit FloatSweeps(const SweepSet& set) {
    for (const Convex& shape : set.shapes) shapes_.emplace_back(shape);
  }

  std::optional<Real> operator()(const SweepQuery& query) {
    FloatSweep<Real> sweep(shapes_[query.shape], toFloat<Real>(query.position), toFloat<Real>(query.displacement));
    return sweep.against(toFloat<Real>(query.segment.a), toFloat<Real>(query.segment.b));
  }

 private:
  std::vector<FloatShape<Real>> shapes_;
};

// b2TimeOfImpact, which Box2D uses for bullets. It stops before the contact, by the slop.
class Box2dSweeps {
 public:
  explicit Box2dSweeps(const SweepSet& set) : scale_(set.subunitsPerMetre) {
    for (const Convex& shape : set.shapes) {
      std::vector<b2Vec2> vertices;
      for (const Point vertex : shape.vertices()) vertices.push_back(metres(vertex));
      shapes_.emplace_back().Set(vertices.data(), static_cast<int32>(vertices.size()));
    }
  }

  std::optional<float> operator()(const SweepQuery& query) {
    b2EdgeShape edge;
    edge.SetTwoSided(metres(query.segment.a), metres(query.segment.b));
    b2TOIInput input;
    input.proxyA.Set(&shapes_[query.shape], 0);
    input.proxyB.Set(&edge, 0);
    input.sweepA = sweepOf(metres(query.position), metres(query.position) + metres(query.displacement));
    input.sweepB = sweepOf({0, 0}, {0, 0});
    input.tMax = 1;
    b2TOIOutput output;
    b2TimeOfImpact(&output, &input);
    if (output.state == b2TOIOutput::e_overlapped) return 0.0F;
    if (output.state == b2TOIOutput::e_touching) return output.t;
    return std::nullopt;
  }

 private:
  b2Vec2 metres(Point point) const {
    return {static_cast<float>(point.x / scale_), static_cast<float>(point.y / scale_)};
  }
  static b2Sweep sweepOf(b2Vec2 from, b2Vec2 to) {
    b2Sweep sweep;
    sweep.localCenter = {0, 0};
    sweep.c0 = from;
    sweep.c = to;
    sweep.a0 = sweep.a = 0;
    sweep.alpha0 = 0;
    return sweep;
  }

  double scale_;
  std::vector<b2PolygonShape> shapes_;
};

oracle::CorrectAnswer correctAnswerOf(const SweepSet& set, const SweepQuery& query) {
  oracle::SweepQuery asked;
  for (const Point vertex : set.shapes[query.shape].vertices()) asked.shape.push_back({vertex.x, vertex.y});
  asked.position = {query.position.x, query.position.y};
  asked.displacement = {query.displacement.x, query.displacement.y};
  asked.segment = {{query.segment.a.x, query.segment.a.y}, {query.segment.b.x, query.segment.b.y}};
  return correctAnswer(asked);
}

// Penetration depth of the shape at this time.
double overlapAt(const SweepSet& set, const SweepQuery& query, long double time) {
  return overlapOf(set.shapes[query.shape], query.position.x + query.displacement.x * time,
                   query.position.y + query.displacement.y * time, query.segment);
}

// The largest penetration depth at 65 times from `from` to 1.
double maxOverlap(const SweepSet& set, const SweepQuery& query, const mpq_class& from) {
  constexpr int kSamples = 64;
  double largest = 0;
  for (int i = 0; i <= kSamples; ++i) {
    const double start = from.get_d();
    largest = std::max(largest, overlapAt(set, query, start + (1 - start) * i / static_cast<long double>(kSamples)));
  }
  return largest;
}

// Compares an answer with the correct one and counts errors. Times are compared as rationals, so that the comparison
// adds no rounding.
void compare(const SweepSet& set, const SweepQuery& query, const oracle::CorrectAnswer& correct, const Answer& answer,
             SweepResult& result) {
  using Kind = oracle::CorrectAnswer::Kind;
  const mpq_class time = rational(correct.numerator, correct.denominator);
  const bool isHit = correct.kind != Kind::Miss;
  result.hits += isHit;
  if (isHit && !answer) {
    ++result.missed;
    result.maxOverlap = std::max(result.maxOverlap, maxOverlap(set, query, time));
  }
  if (!isHit && answer) ++result.falseHits;
  if (correct.kind != Kind::Hit || !answer) return;
  result.maxTimeError = std::max(result.maxTimeError, mpq_class(abs(*answer - time)).get_d());
  if (*answer > time) result.maxOverlap = std::max(result.maxOverlap, overlapAt(set, query, answer->get_d()));
}

struct Contender {
  std::string engine;
  std::function<Answer(const SweepQuery&)> ask;
  std::function<double()> pass;  // nanoseconds per query
};

template <class Sweeps>
Contender contender(const std::string& engine, const SweepSet& set) {
  const auto sweeps = std::make_shared<Sweeps>(set);
  const auto pass = [sweeps, &set] {
    const double nanoseconds = nanosecondsOf([&] {
      for (const SweepQuery& query : set.queries) keep((*sweeps)(query));
    });
    return nanoseconds / static_cast<double>(set.queries.size());
  };
  const auto ask = [sweeps](const SweepQuery& query) -> Answer {
    const auto time = (*sweeps)(query);
    return time ? Answer(exactly(*time)) : std::nullopt;
  };
  return {engine, ask, pass};
}

std::vector<Contender> contenders(const SweepSet& set) {
  std::vector<Contender> all{contender<PlatonSweeps>("platon", set), contender<FloatSweeps<float>>("float32", set),
                             contender<FloatSweeps<double>>("float64", set)};
  if (set.shapes.front().vertices().size() <= b2_maxPolygonVertices)
    all.push_back(contender<Box2dSweeps>("box2d-2.4", set));
  return all;
}

std::vector<SweepResult> benchSet(const SweepSet& set, const Effort& effort) {
  const auto all = contenders(set);
  std::vector<SweepResult> results;
  for (const Contender& one : all) {
    SweepResult result;
    result.set = set.name;
    result.engine = one.engine;
    result.queries = set.queries.size();
    results.push_back(std::move(result));
  }
  for (const SweepQuery& query : set.queries) {
    const oracle::CorrectAnswer correct = correctAnswerOf(set, query);
    for (std::size_t i = 0; i < all.size(); ++i) compare(set, query, correct, all[i].ask(query), results[i]);
  }
  std::vector<std::function<double()>> passes;
  for (const Contender& one : all) passes.push_back(one.pass);
  const auto spreads = interleaved(passes, effort.passes);
  for (std::size_t i = 0; i < all.size(); ++i) results[i].nsPerQuery = spreads[i];
  return results;
}

}  // namespace

std::vector<SweepResult> benchSweeps(const Effort& effort) {
  std::vector<SweepResult> results;
  for (const SweepSet& set : sweepSets(kQueries / static_cast<std::size_t>(effort.divisor))) {
    for (SweepResult& result : benchSet(set, effort)) results.push_back(std::move(result));
  }
  return results;
}

}  // namespace platon::bench
