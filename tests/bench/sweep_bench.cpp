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
#include "tests/bench/float_sweep.h"
#include "tests/bench/overlap.h"
#include "tests/bench/sweep_sets.h"
#include "tests/exactness/oracle/sweep/sweep_oracle.h"

namespace platon::bench {
namespace {

constexpr std::size_t kQuestions = 20000;

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

  std::optional<Fraction> operator()(const SweepQuestion& question) {
    sweep_.start(set_.shapes[question.shape], question.position, question.displacement);
    const auto hit = sweep_.against(question.line);
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

  std::optional<Real> operator()(const SweepQuestion& question) {
    FloatSweep<Real> sweep(shapes_[question.shape], toFloat<Real>(question.position),
                           toFloat<Real>(question.displacement));
    return sweep.against(toFloat<Real>(question.line.a), toFloat<Real>(question.line.b));
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

  std::optional<float> operator()(const SweepQuestion& question) {
    b2EdgeShape edge;
    edge.SetTwoSided(metres(question.line.a), metres(question.line.b));
    b2TOIInput input;
    input.proxyA.Set(&shapes_[question.shape], 0);
    input.proxyB.Set(&edge, 0);
    input.sweepA = sweepOf(metres(question.position), metres(question.position) + metres(question.displacement));
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

oracle::SweepTruth truthOf(const SweepSet& set, const SweepQuestion& question) {
  oracle::SweepQuery query;
  for (const Point vertex : set.shapes[question.shape].vertices()) query.shape.push_back({vertex.x, vertex.y});
  query.position = {question.position.x, question.position.y};
  query.displacement = {question.displacement.x, question.displacement.y};
  query.obstacle = {{question.line.a.x, question.line.a.y}, {question.line.b.x, question.line.b.y}};
  return sweepTruth(query);
}

// Penetration depth of the shape at this time.
double overlapAt(const SweepSet& set, const SweepQuestion& question, long double time) {
  return overlapOf(set.shapes[question.shape], question.position.x + question.displacement.x * time,
                   question.position.y + question.displacement.y * time, question.line);
}

// The largest penetration depth at 65 times from `from` to 1.
double maxOverlap(const SweepSet& set, const SweepQuestion& question, const mpq_class& from) {
  constexpr int kSamples = 64;
  double largest = 0;
  for (int i = 0; i <= kSamples; ++i) {
    const double start = from.get_d();
    largest = std::max(largest, overlapAt(set, question, start + (1 - start) * i / static_cast<long double>(kSamples)));
  }
  return largest;
}

// Compares an answer with the truth and counts errors. Times are compared as rationals, so that the comparison adds no
// rounding.
void compare(const SweepSet& set, const SweepQuestion& question, const oracle::SweepTruth& truth, const Answer& answer,
             SweepResult& result) {
  using Kind = oracle::SweepTruth::Kind;
  const mpq_class time = rational(truth.numerator, truth.denominator);
  const bool meets = truth.kind != Kind::Miss;
  result.meetings += meets;
  if (meets && !answer) {
    ++result.missed;
    result.maxOverlap = std::max(result.maxOverlap, maxOverlap(set, question, time));
  }
  if (!meets && answer) ++result.falseHits;
  if (truth.kind != Kind::Hit || !answer) return;
  result.maxTimeError = std::max(result.maxTimeError, mpq_class(abs(*answer - time)).get_d());
  if (*answer > time) result.maxOverlap = std::max(result.maxOverlap, overlapAt(set, question, answer->get_d()));
}

struct Contender {
  std::string engine;
  std::function<Answer(const SweepQuestion&)> ask;
  std::function<double()> pass;  // nanoseconds per query
};

template <class Sweeps>
Contender contender(const std::string& engine, const SweepSet& set) {
  const auto sweeps = std::make_shared<Sweeps>(set);
  const auto pass = [sweeps, &set] {
    const double nanoseconds = nanosecondsOf([&] {
      for (const SweepQuestion& question : set.questions) keep((*sweeps)(question));
    });
    return nanoseconds / static_cast<double>(set.questions.size());
  };
  const auto ask = [sweeps](const SweepQuestion& question) -> Answer {
    const auto time = (*sweeps)(question);
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
    result.questions = set.questions.size();
    results.push_back(std::move(result));
  }
  for (const SweepQuestion& question : set.questions) {
    const oracle::SweepTruth truth = truthOf(set, question);
    for (std::size_t i = 0; i < all.size(); ++i) compare(set, question, truth, all[i].ask(question), results[i]);
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
  for (const SweepSet& set : sweepSets(kQuestions / static_cast<std::size_t>(effort.share))) {
    for (SweepResult& result : benchSet(set, effort)) results.push_back(std::move(result));
  }
  return results;
}

}  // namespace platon::bench
