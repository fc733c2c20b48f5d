#pragma once

#include <cstdint>

namespace platon {

/// Bytes that are allocated in this process, those of C libraries included.
std::int64_t heapBytes();

/// Adds what a block of code has allocated and not released to a sum.
class HeapGauge {
 public:
  explicit HeapGauge(std::int64_t& sum) : sum_(sum), before_(heapBytes()) {}
  ~HeapGauge() { sum_ += heapBytes() - before_; }
  HeapGauge(const HeapGauge&) = delete;
  HeapGauge& operator=(const HeapGauge&) = delete;

 private:
  std::int64_t& sum_;
  std::int64_t before_;
};

}  // namespace platon
