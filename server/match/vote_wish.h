#pragma once

#include <cstdint>

#include "platon/game/game.h"

namespace platon {

/// Whether a player wishes the next level. The player may change its mind at any time. What counts follows its last
/// wish, but changes at most once in kMinTicks, so that a flood of votes does not make the counts of others flicker.
class VoteWish {
 public:
  static constexpr std::uint64_t kMinTicks = kTicksPerSecond;

  void set(bool next) { last_ = next; }
  /// No wish, from now on.
  void clear() { last_ = counts_ = false; }
  /// Whether the wish counts at tick `now` of the match, which never decreases.
  bool counts(std::uint64_t now) {
    if (last_ != counts_ && now >= changeableAt_) {
      counts_ = last_;
      changeableAt_ = now + kMinTicks;
    }
    return counts_;
  }

 private:
  bool last_ = false;
  bool counts_ = false;
  std::uint64_t changeableAt_ = 0;
};

}  // namespace platon
