#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace platon {

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
