#pragma once

#include <cstddef>
#include <utility>

#include "tests/support/counted_heap.h"

namespace platon::bench {

/// Bytes of the heap in use, with the overhead of the allocator and a few that it keeps for reuse. Counts C libraries,
/// too.
std::size_t heapBytes();

/// Heap that `live` uses beyond its value: caches and work space, which a copy does not have.
template <class Value>
double derivedBytes(Value& live) {
  const std::size_t start = allocatedBytes();
  Value copy = live;
  const std::size_t withCopy = allocatedBytes();
  { const Value gone = std::move(live); }
  const std::size_t withoutLive = allocatedBytes();
  live = std::move(copy);
  return static_cast<double>(withCopy - withoutLive) - static_cast<double>(withCopy - start);
}

}  // namespace platon::bench
