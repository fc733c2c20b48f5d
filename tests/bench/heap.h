#pragma once

#include <cstddef>
#include <utility>

namespace platon::bench {

/// Bytes of the heap in use, with the overhead of the allocator.
std::size_t heapBytes();

/// Number of calls of operator new so far. A program that calls this function counts them.
std::size_t allocations();

/// Heap that `live` uses beyond its value: caches and work space, which a copy does not have.
template <class Value>
double derivedBytes(Value& live) {
  const std::size_t start = heapBytes();
  Value copy = live;
  const std::size_t withCopy = heapBytes();
  { const Value gone = std::move(live); }
  const std::size_t withoutLive = heapBytes();
  live = std::move(copy);
  return static_cast<double>(withCopy - withoutLive) - static_cast<double>(withCopy - start);
}

}  // namespace platon::bench
