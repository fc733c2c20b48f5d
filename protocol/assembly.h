#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace platon {

/// Puts the pieces of a level text or a state together again. One piece out of order spoils the whole; a piece at
/// offset 0 starts anew.
class Assembly {
 public:
  /// True when this piece completes the whole. Takes no more memory than has arrived.
  bool add(std::uint32_t total, std::uint32_t offset, std::span<const std::uint8_t> piece);

  /// What has arrived so far.
  const std::vector<std::uint8_t>& bytes() const { return bytes_; }
  void clear();

 private:
  std::vector<std::uint8_t> bytes_;
  std::uint32_t total_ = 0;
};

}  // namespace platon
