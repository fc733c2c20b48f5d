#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace platon {

/// Joins the pieces of a level text or a full state. A piece out of order discards what was joined so far; a piece at
/// offset 0 starts a new whole.
class Assembly {
 public:
  /// Adds a piece of a whole of `total` bytes. True when it completes the whole. Memory grows with the bytes received,
  /// not with `total`.
  bool add(std::uint32_t total, std::uint32_t offset, std::span<const std::uint8_t> piece);

  /// The bytes joined so far.
  const std::vector<std::uint8_t>& bytes() const { return bytes_; }
  void clear();

 private:
  std::vector<std::uint8_t> bytes_;
  std::uint32_t total_ = 0;
};

}  // namespace platon
