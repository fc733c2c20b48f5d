#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "protocol/files/kept_file.h"

namespace platon {

/// The levels whose goal the player has reached alone, at any speed, without a time: a text file with the hash of a
/// level in each line. Lines that begin with `#` and those that are no hash are left out. A file that cannot be read
/// has none, and is not written.
class ReachedLevels {
 public:
  /// Most levels; those that were reached first are forgotten.
  static constexpr std::size_t kMaxLevels = 10'000;

  /// Reads the file. An empty path: nothing is kept.
  explicit ReachedLevels(std::filesystem::path file);

  bool has(std::uint64_t level) const;
  /// Adds a level to what the file holds now, unless it is known already. Returns why that failed, a sentence that
  /// names the file, or an empty text. Does not wait for the disk, but for another program that adds one.
  std::string add(std::uint64_t level);

 private:
  KeptFile file_;
  std::vector<std::uint64_t> levels_;  // in the order in which they were reached
};

}  // namespace platon
