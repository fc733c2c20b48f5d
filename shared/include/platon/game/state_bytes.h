#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

#include "platon/exact/angle.h"
#include "platon/exact/integer.h"
#include "platon/exact/point.h"

namespace platon {

/// Encodes integers as little-endian bytes on every machine.
class StateWriter {
 public:
  template <FixedInteger Integer>
  void add(Integer value) {
    const auto bits = static_cast<std::make_unsigned_t<Integer>>(value);
    for (std::size_t i = 0; i < sizeof(Integer); ++i) bytes_.push_back(static_cast<std::uint8_t>(bits >> (8 * i)));
  }
  void add(Point point) {
    add(point.x);
    add(point.y);
  }
  void add(Angle angle) { add(angle.centidegrees()); }
  /// Appends bytes or text as they are.
  template <class Bytes>
  void append(const Bytes& bytes) {
    bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
  }

  std::span<const std::uint8_t> bytes() const { return bytes_; }
  std::vector<std::uint8_t> take() { return std::move(bytes_); }

 private:
  std::vector<std::uint8_t> bytes_;
};

/// Decodes what StateWriter has encoded. Reading past the end, or an angle out of range, gives zero and makes ok()
/// false.
class StateReader {
 public:
  explicit StateReader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  template <FixedInteger Integer>
  void read(Integer& value) {
    std::make_unsigned_t<Integer> bits = 0;
    if (remaining() < sizeof(Integer)) {
      ok_ = false;
      next_ = bytes_.size();
    } else {
      for (std::size_t i = 0; i < sizeof(Integer); ++i) {
        bits =
            static_cast<decltype(bits)>(bits | static_cast<decltype(bits)>(std::uint64_t{bytes_[next_++]} << (8 * i)));
      }
    }
    value = static_cast<Integer>(bits);
  }
  void read(Point& point) {
    read(point.x);
    read(point.y);
  }
  void read(Angle& angle) {
    std::int32_t centidegrees = 0;
    read(centidegrees);
    if (centidegrees < 0 || centidegrees >= Angle::kTurn) {
      ok_ = false;
      centidegrees = 0;
    }
    angle = Angle(centidegrees);
  }

  /// Returns the next `count` bytes, or as many as remain.
  std::span<const std::uint8_t> take(std::size_t count) {
    if (remaining() < count) {
      ok_ = false;
      count = remaining();
    }
    next_ += count;
    return bytes_.subspan(next_ - count, count);
  }

  /// Index of the next byte.
  std::size_t next() const { return next_; }
  std::size_t remaining() const { return bytes_.size() - next_; }
  /// False after a read past the end or of a value out of range.
  bool ok() const { return ok_; }
  /// True when every byte has been read, without an error.
  bool finished() const { return ok_ && remaining() == 0; }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t next_ = 0;
  bool ok_ = true;
};

}  // namespace platon
