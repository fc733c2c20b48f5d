#pragma once

#include <chrono>
#include <cstdint>

#include "platon/game/game.h"
#include "protocol/chat.h"
#include "protocol/moment.h"
#include "protocol/token_bucket.h"

namespace platon {

/// How much may be said in a match, in ticks of the match.
class ChatBudget {
 public:
  static constexpr double kPerSecondOfAll = 8;  ///< of all players: each text is sent to all of them
  static constexpr double kBurstOfAll = 16;

  static ChatBudget ofPlayer() { return {kChatsPerSecond, kChatBurst}; }
  static ChatBudget ofAll() { return {kPerSecondOfAll, kBurstOfAll}; }

  /// Whether one more may be said at tick `now` of the match, which never decreases; it counts then.
  bool take(std::uint64_t now) { return bucket_.take(1, momentOf(now)); }

 private:
  ChatBudget(double perSecond, double burst) : bucket_(perSecond, burst, Moment(0)) {}
  static Moment momentOf(std::uint64_t tick) { return std::chrono::microseconds(tick * 1'000'000 / kTicksPerSecond); }

  TokenBucket bucket_;
};

}  // namespace platon
