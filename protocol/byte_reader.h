#pragma once

#include <cstdint>
#include <span>

namespace platon {

/// Reads what ByteWriter wrote. Reading past the end, or a varint that is longer than necessary or exceeds 32 bits,
/// returns 0 and makes `ok` false from then on.
class ByteReader {
 public:
  explicit ByteReader(std::span<const std::uint8_t> bytes) : remaining_(bytes) {}

  std::uint8_t byte();
  std::uint32_t fixed32();
  std::uint32_t varint();

  bool ok() const { return ok_; }
  bool atEnd() const { return remaining_.empty(); }
  /// The bytes not read yet.
  std::span<const std::uint8_t> remaining() const { return remaining_; }

 private:
  std::span<const std::uint8_t> remaining_;
  bool ok_ = true;
};

}  // namespace platon
