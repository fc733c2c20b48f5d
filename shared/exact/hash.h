#pragma once

#include <cstdint>
#include <type_traits>

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

/// A 64-bit hash of the fields of a record: a sequence of integers whose types are the same for all records of its
/// kind. Successive integers that fit 64 bits together are hashed as one, which is fast; two records that differ in one
/// field always have different hashes. The same on every platform.
class RecordHash {
 public:
  template <FixedInteger Integer>
  void add(Integer value) {
    constexpr int bits = 8 * static_cast<int>(sizeof(Integer));
    if (used_ + bits > 64) flush();
    word_ |= static_cast<std::uint64_t>(static_cast<std::make_unsigned_t<Integer>>(value)) << used_;
    used_ += bits;
  }
  void add(Point point) {
    add(point.x);
    add(point.y);
  }
  void add(Angle angle) { add(angle.centidegrees()); }

  std::uint64_t value() {
    flush();
    return hash_.value();
  }

 private:
  void flush() {
    if (used_ != 0) hash_.add(word_);
    word_ = 0;
    used_ = 0;
  }

  Hash hash_;
  std::uint64_t word_ = 0;  // integers that are not hashed yet
  int used_ = 0;            // bits of word_
};

/// Hash of the fields that `Record::visit` lists.
template <class Record>
std::uint64_t hashOfRecord(const Record& record) {
  RecordHash hash;
  Record::visit(record, [&](const char*, const auto& field) { hash.add(field); });
  return hash.value();
}

/// Hash of the size and the bytes of a container whose elements are one byte wide.
template <class Bytes>
std::uint64_t hashOf(const Bytes& bytes) {
  Hash hash;
  hash.add(std::uint64_t{bytes.size()});
  for (const auto byte : bytes) hash.add(static_cast<std::uint8_t>(byte));
  return hash.value();
}

}  // namespace platon
