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

/// Appends integers as bytes, least significant first, on every machine.
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
  /// Another writer's bytes, or text.
  template <class Bytes>
  void append(const Bytes& bytes) {
    bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
  }

  std::span<const std::uint8_t> bytes() const { return bytes_; }
  std::vector<std::uint8_t> take() { return std::move(bytes_); }

 private:
  std::vector<std::uint8_t> bytes_;
};

/// Reads them back. Past the end, or on a value that no state holds, it reads zeros and says so at the end.
class StateReader {
 public:
  explicit StateReader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  template <FixedInteger Integer>
  void read(Integer& value) {
    std::make_unsigned_t<Integer> bits = 0;
    if (left() < sizeof(Integer)) {
      sound_ = false;
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
      sound_ = false;
      centidegrees = 0;
    }
    angle = Angle(centidegrees);
  }

  /// The next bytes as they are.
  std::span<const std::uint8_t> take(std::size_t count) {
    if (left() < count) {
      sound_ = false;
      count = left();
    }
    next_ += count;
    return bytes_.subspan(next_ - count, count);
  }

  std::size_t next() const { return next_; }
  std::size_t left() const { return bytes_.size() - next_; }
  /// Nothing was missing, wrong or left over.
  bool finished() const { return sound_ && left() == 0; }
  bool sound() const { return sound_; }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t next_ = 0;
  bool sound_ = true;
};

}  // namespace platon
