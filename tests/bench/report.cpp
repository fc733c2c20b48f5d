#include "tests/bench/report.h"

namespace platon::bench {

Report runAll(const Effort& effort, const std::function<void(const char*)>& begins) {
  const auto measured = [&](const char* what, auto measure) {
    begins(what);
    return measure(effort);
  };
  Report report;
  report.passes = effort.passes;
  report.sweeps = measured("sweeps", &benchSweeps);
  report.steps = measured("whole steps", &benchSteps);
  report.hardCases = measured("hard cases", &benchHardCases);
  report.resolutions = measured("resolutions", &benchResolutions);
  report.trajectories = measured("trajectories", &benchTrajectories);
  report.parts = measured("parts", &benchParts);
  report.games = measured("games", &benchGames);
  return report;
}

}  // namespace platon::bench
