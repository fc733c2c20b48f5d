#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tests/bench/game_bench.h"
#include "tests/bench/hard_bench.h"
#include "tests/bench/parts_bench.h"
#include "tests/bench/resolution_bench.h"
#include "tests/bench/steps/step_bench.h"
#include "tests/bench/sweep_bench.h"
#include "tests/bench/trajectory_bench.h"

namespace platon::bench {

/// Results of a run.
struct Report {
  int passes = 0;
  std::vector<SweepResult> sweeps;
  std::vector<StepResult> steps;
  std::vector<HardResult> hardCases;
  std::vector<ResolutionResult> resolutions;
  TrajectoryResults trajectories;
  std::vector<PartResult> parts;
  GameResults games;
};

/// Runs all benchmarks, which takes minutes. Calls `begins` with the name of each part before it starts. Requires the
/// root of the tree as working folder.
Report runAll(const Effort& effort, const std::function<void(const char*)>& begins);

/// One JSON object. Times are medians; the lowest and the highest pass are given as well.
std::string toJson(const Report& report);

/// Tables for reading.
std::string toText(const Report& report);

}  // namespace platon::bench
