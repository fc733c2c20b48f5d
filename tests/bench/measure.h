#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace platon::bench {

struct EngineKind;

/// Median, minimum and maximum of several passes.
struct Spread {
  double median = 0;
  double low = 0;
  double high = 0;
};

Spread spreadOf(std::vector<double> passes);

/// Runs all `contenders` alternately, `passes` times each, so that other load on the machine affects all alike. Each
/// returns the value that it measured in the pass.
std::vector<Spread> interleaved(const std::vector<std::function<double()>>& contenders, int passes);

/// Processor time of this thread, in nanoseconds. Time of other programs does not count.
double processorTime();

/// Processor time of `work`, in nanoseconds.
template <class Work>
double nanosecondsOf(Work&& work) {
  const double start = processorTime();
  work();
  return processorTime() - start;
}

/// Keeps the compiler from removing the computation of `value`.
template <class Value>
void keep(const Value& value) {
  asm volatile("" : : "g"(&value) : "memory");
}

/// Amount of work of a run.
struct Effort {
  int passes = 15;                    ///< at least five
  std::int64_t divisor = 1;           ///< divides the amount of work
  std::size_t maxSegments = 100000;   ///< per scene
  const EngineKind* guest = nullptr;  ///< also takes part in whole steps, hard cases and trajectories

  static Effort quick() { return {.passes = 5, .divisor = 10}; }
};

}  // namespace platon::bench
