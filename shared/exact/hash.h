#pragma once

#include <cstdint>

#include "platon/exact/angle.h"
#include "platon/exact/integer.h"
#include "platon/exact/point.h"

namespace platon {

/// A 64-bit hash of a sequence of integers. Hashes values, not memory, so the result is the same on every platform.
/// Each step is a bijection of the state for a given value, and of the value for a given state: two sequences of equal
/// length that differ in one value always have different hashes. Not cryptographic.
class Hash {
 public:
  /// Adds `value` modulo 2^64; the width of its type does not influence the hash.
  template <FixedInteger Integer>
  void add(Integer value) {
    state_ ^= static_cast<std::uint64_t>(value);
    state_ *= 0x9e3779b97f4a7c15U;  // odd: 2^64 divided by the golden ratio
    state_ ^= state_ >> 32;
  }
  void add(Point point) {
    add((std::uint64_t{static_cast<std::uint32_t>(point.x)} << 32) | static_cast<std::uint32_t>(point.y));
  }
  void add(Angle angle) { add(angle.centidegrees()); }

  std::uint64_t value() const { return state_; }

 private:
  std::uint64_t state_ = 0xcbf29ce484222325U;  // not 0: a first value of 0 would leave 0 unchanged
};

/// Hash of the size and the bytes of a container whose elements are one byte wide.
template <class Bytes>
std::uint64_t hashOf(const Bytes& bytes) {
  Hash hash;
  hash.add(std::uint64_t{bytes.size()});
  for (const auto byte : bytes) hash.add(static_cast<std::uint8_t>(byte));
  return hash.value();
}

}  // namespace platon
