#pragma once

#include <cstdint>

#include "platon/exact/angle.h"
#include "platon/exact/integer.h"
#include "platon/exact/point.h"

namespace platon {

/// A 64-bit hash of integers, the same on every machine: it works on values, not on bytes in memory. Each step is a
/// bijection of the state for a given value and of the value for a given state, so that a single change always shows.
class Hash {
 public:
  /// A negative number counts as its value modulo 2^64, so that the width of its type does not matter.
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
  std::uint64_t state_ = 0xcbf29ce484222325U;  // any but 0, which would map a first 0 to itself
};

/// Of bytes, of whatever type, and their number.
template <class Bytes>
std::uint64_t hashOf(const Bytes& bytes) {
  Hash hash;
  hash.add(std::uint64_t{bytes.size()});
  for (const auto byte : bytes) hash.add(static_cast<std::uint8_t>(byte));
  return hash.value();
}

}  // namespace platon
