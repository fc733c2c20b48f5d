#include "tests/exactness/reference/terrain_judge.h"

#include <algorithm>

#include "tests/exactness/reference/ideal_path.h"
#include "tests/exactness/reference/simulated_body.h"

namespace platon::reference {

Verdict judge(const ExactScene& scene, std::int64_t ticks) {
  const IdealPath ideal(scene, ticks);
  Verdict verdict{ticks, ideal.legs().size(), ideal.touchesBetween(ticks - kContactTicks, ticks)};
  if (ideal.legs().back().kind == IdealPath::Kind::kRest) verdict.restsAt = ideal.legs().back().begin.get_d();
  if (!verdict.inContact) return verdict;
  SimulatedBody body(scene);
  for (std::int64_t tick = 1; tick <= ticks; ++tick) {
    body.tick();
    const RationalVec correct = ideal.positionAt(tick);
    const double lattice = distance(body.position(), correct);
    verdict.maxLattice = std::max(verdict.maxLattice, lattice);
    verdict.maxPrecise = std::max(verdict.maxPrecise, distance(body.precisePosition(), correct));
    if (lattice > kMaxLatticeError && verdict.firstAbove == 0) verdict.firstAbove = tick;
  }
  return verdict;
}

}  // namespace platon::reference
