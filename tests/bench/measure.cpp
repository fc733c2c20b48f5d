#include "tests/bench/measure.h"

#include <time.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace platon::bench {

double processorTime() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * 1e9 + static_cast<double>(now.tv_nsec);
}

Spread spreadOf(std::vector<double> passes) {
  std::sort(passes.begin(), passes.end());
  return {passes[passes.size() / 2], passes.front(), passes.back()};
}

std::vector<Spread> interleaved(const std::vector<std::function<double()>>& contenders, int passes) {
  std::vector<std::vector<double>> measured(contenders.size());
  for (int pass = 0; pass < passes; ++pass) {
    for (std::size_t i = 0; i < contenders.size(); ++i) measured[i].push_back(contenders[i]());
  }
  std::vector<Spread> spreads;
  for (auto& values : measured) spreads.push_back(spreadOf(std::move(values)));
  return spreads;
}

}  // namespace platon::bench
