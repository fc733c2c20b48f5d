#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace platon {

/// Writes the compact byte strings inside messages.
class ByteWriter {
 public:
  void byte(std::uint8_t value) { bytes_.push_back(value); }
  void fixed32(std::uint32_t value);  ///< four bytes, the lowest first
  void varint(std::uint32_t value);   ///< seven bits a byte, the lowest first, the top bit says that more follow
  void raw(std::span<const std::uint8_t> bytes) { bytes_.insert(bytes_.end(), bytes.begin(), bytes.end()); }

  std::vector<std::uint8_t> take() { return std::move(bytes_); }

 private:
  std::vector<std::uint8_t> bytes_;
};

}  // namespace platon
