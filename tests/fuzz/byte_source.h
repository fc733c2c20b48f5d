#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "tests/exactness/oracle/exact_geometry.h"

namespace platon::fuzz {

/// Makes choices from the bytes of a fuzzer, in order. After the last byte every byte is zero. Small ranges use few
/// bytes, so that a changed byte changes one choice.
class ByteSource {
 public:
  explicit ByteSource(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  bool empty() const { return next_ == bytes_.size(); }
  std::uint8_t byte() { return empty() ? std::uint8_t{0} : bytes_[next_++]; }
  /// The bytes that have not been used.
  std::span<const std::uint8_t> remaining() { return bytes_.subspan(next_); }

  /// low … high, both included; low after the last byte. The range is at most 2^32.
  std::int64_t between(std::int64_t low, std::int64_t high) {
    const auto span = static_cast<std::uint64_t>(high - low) + 1;
    std::uint64_t value = 0;
    for (std::uint64_t covered = 1; covered < span; covered <<= 8) value = value << 8 | byte();
    return low + static_cast<std::int64_t>(value % span);
  }
  bool flag() { return (byte() & 1) != 0; }
  /// An index below `count`.
  std::size_t below(std::size_t count) {
    return static_cast<std::size_t>(between(0, static_cast<std::int64_t>(count) - 1));
  }
  /// Each component -radius … radius, zero after the last byte.
  oracle::Vec vector(std::int64_t radius) {
    const std::int64_t x = signedWithin(radius);
    return {x, signedWithin(radius)};
  }

 private:
  // The sign is in the lowest bit, so that zero bytes give zero.
  std::int64_t signedWithin(std::int64_t radius) {
    const std::int64_t folded = between(0, 2 * radius);
    return folded % 2 == 0 ? folded / 2 : -(folded / 2 + 1);
  }

  std::span<const std::uint8_t> bytes_;
  std::size_t next_ = 0;
};

}  // namespace platon::fuzz
