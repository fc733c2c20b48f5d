#include "client/netcode/send_schedule.h"

#include <algorithm>
#include <chrono>

namespace platon {

namespace {

constexpr std::uint32_t kTicksBetweenMessages = 4;
constexpr std::uint32_t kRepeats = 2;  // of a change, one per tick
constexpr Moment kIdleInterval = std::chrono::milliseconds(80);

}  // namespace

void SendSchedule::addInput(Input input) {
  hasNew_ = true;
  changed_ = changed_ || input != last_;
  last_ = input;
}

bool SendSchedule::due(Moment now, std::uint32_t end) const {
  if (!sentAt_ || now - *sentAt_ >= kIdleInterval || urgent_) return true;
  if (!hasNew_ || end <= sentEnd_) return false;
  return repeats_ > 0 || end - sentEnd_ >= kTicksBetweenMessages || changed_;
}

void SendSchedule::sent(Moment now, std::uint32_t end) {
  repeats_ = changed_ ? kRepeats : repeats_ - std::min(repeats_, 1u);
  hasNew_ = changed_ = urgent_ = false;
  sentAt_ = now;
  sentEnd_ = end;
}

}  // namespace platon
