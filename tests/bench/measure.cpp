#include "tests/bench/measure.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace platon::bench {

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
