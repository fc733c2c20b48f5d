#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace platon::bench {

/// Medians and spread of passes.
struct Spread {
  double median = 0;
  double low = 0;
  double high = 0;
};

Spread spreadOf(std::vector<double> passes);

/// Runs all `contenders` once, then once more and so on, so that what else the machine does hits all alike. Each
/// returns what it measured in that pass.
std::vector<Spread> interleaved(const std::vector<std::function<double()>>& contenders, int passes);

/// Nanoseconds of the processor that this thread has had: those that other programs took from it do not count.
double processorTime();

/// Nanoseconds of the processor that `work` takes.
template <class Work>
double nanosecondsOf(Work&& work) {
  const double start = processorTime();
  work();
  return processorTime() - start;
}

/// Makes the compiler believe that `value` is needed.
template <class Value>
void keep(const Value& value) {
  asm volatile("" : : "g"(&value) : "memory");
}

/// How thorough the run is.
struct Effort {
  int passes = 15;                    ///< at least five
  std::int64_t share = 1;             ///< work is divided by this
  std::size_t mostSegments = 100000;  ///< in a scene

  static Effort quick() { return {.passes = 5, .share = 10}; }
};

}  // namespace platon::bench
