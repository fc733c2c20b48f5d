#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace platon {

using Bytes = std::vector<std::uint8_t>;
using ByteSpan = std::span<const std::uint8_t>;

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

/// Writes the compact byte strings that messages carry.
class ByteWriter {
 public:
  ByteWriter() { bytes_.reserve(kUsualBytes); }

  void byte(std::uint8_t value) { bytes_.push_back(value); }
  void fixed32(std::uint32_t value);  ///< four bytes, least significant first
  void varint(std::uint32_t value);   ///< LEB128: seven bits a byte, least significant first; top bit: more follow
  void raw(std::span<const std::uint8_t> bytes) { bytes_.insert(bytes_.end(), bytes.begin(), bytes.end()); }

  std::vector<std::uint8_t> take() { return std::move(bytes_); }

 private:
  static constexpr std::size_t kUsualBytes = 96;  // most messages of a tick are shorter

  std::vector<std::uint8_t> bytes_;
};

}  // namespace platon
