#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tests/bench/game_bench.h"
#include "tests/bench/hard_bench.h"
#include "tests/bench/parts_bench.h"
#include "tests/bench/resolution_bench.h"
#include "tests/bench/step_bench.h"
#include "tests/bench/sweep_bench.h"

namespace platon::bench {

/// All that one run measures.
struct Report {
  int passes = 0;
  std::vector<SweepResult> sweeps;
  std::vector<StepResult> steps;
  std::vector<HardResult> hardCases;
  std::vector<ResolutionResult> resolutions;
  std::vector<PartResult> parts;
  GameResults games;
};

/// Measures everything; tells `begins` the name of each part first, for the whole takes minutes. Run from the root of
/// the tree, where levels and scenes are.
Report runAll(const Effort& effort, const std::function<void(const char*)>& begins);

/// One JSON object. Times are medians; beside each stands the lowest and the highest of the passes.
std::string toJson(const Report& report);

/// Tables for people.
std::string toText(const Report& report);

}  // namespace platon::bench
