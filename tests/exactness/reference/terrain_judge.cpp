#include "tests/exactness/reference/terrain_judge.h"

#include <algorithm>

#include "tests/exactness/reference/ideal_path.h"
#include "tests/exactness/reference/simulated_body.h"

namespace platon::reference {

namespace {

std::int64_t judgedTicks(const Tie& tie, std::int64_t ticks) {
  switch (tie.kind) {
    case Tie::Kind::kNone:
      return ticks;
    case Tie::Kind::kNarrow:
    case Tie::Kind::kJoint:
      return static_cast<std::int64_t>(tie.tick);
    default:
      return 0;
  }
}

Verdict verdictOfIdeal(const ExactScene& scene, const IdealPath& ideal, std::int64_t ticks) {
  Verdict verdict;
  verdict.ticks = ticks;
  verdict.idealLegs = ideal.legs().size();
  verdict.inContact = ideal.touchesBetween(ticks - kContactTicks, ticks);
  const IdealPath::Leg& last = ideal.legs().back();
  if (last.kind == IdealPath::Kind::kRest) verdict.restsAt = last.begin.get_d();
  if (!verdict.inContact) return verdict;
  verdict.tie = findTie(scene, ideal, ticks);
  verdict.judgedTicks = judgedTicks(verdict.tie, ticks);
  return verdict;
}

}  // namespace

Verdict judge(const ExactScene& scene, std::int64_t ticks, JudgedBody& body) {
  const IdealPath ideal(scene, ticks);
  Verdict verdict = verdictOfIdeal(scene, ideal, ticks);
  for (std::int64_t tick = 1; tick <= verdict.judgedTicks; ++tick) {
    body.tick();
    const RationalVec correct = ideal.positionAt(tick);
    const double lattice = distance(body.position(), correct);
    verdict.maxLattice = std::max(verdict.maxLattice, lattice);
    verdict.maxPrecise = std::max(verdict.maxPrecise, distance(body.precisePosition(), correct));
    if (lattice > kMaxLatticeError && verdict.firstAbove == 0) verdict.firstAbove = tick;
  }
  return verdict;
}

Verdict judge(const ExactScene& scene, std::int64_t ticks) {
  SimulatedBody body(scene);
  return judge(scene, ticks, body);
}

}  // namespace platon::reference
