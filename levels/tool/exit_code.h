#pragma once

namespace platon {

// Exit codes of platon-level.
inline constexpr int kFailed = 1;
inline constexpr int kUsage = 2;  ///< also for a file that cannot be read
inline constexpr int kInvalidLevel = 3;

}  // namespace platon
