#pragma once

#include <cstdint>
#include <span>

namespace platon {

/// Reads what ByteWriter wrote. Reading past the end, or a varint that ByteWriter would have written in another way,
/// gives 0 and makes `ok` false for good.
class ByteReader {
 public:
  explicit ByteReader(std::span<const std::uint8_t> bytes) : rest_(bytes) {}

  std::uint8_t byte();
  std::uint32_t fixed32();
  std::uint32_t varint();

  bool ok() const { return ok_; }
  bool atEnd() const { return rest_.empty(); }
  std::span<const std::uint8_t> rest() const { return rest_; }

 private:
  std::span<const std::uint8_t> rest_;
  bool ok_ = true;
};

}  // namespace platon
