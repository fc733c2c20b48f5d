#include "protocol/loss_meter.h"

#include <algorithm>

namespace platon {

void LossMeter::received(std::uint8_t sequence) {
  const auto back = static_cast<std::uint8_t>(newest_ - sequence);
  if (known_ > 0 && back < kWindow) {
    if (back < known_) arrived_.set(back);
    return;
  }
  const auto steps = static_cast<std::uint8_t>(sequence - newest_);
  arrived_ <<= steps;
  arrived_.set(0);
  known_ = known_ == 0 ? 1 : std::min(known_ + steps, kWindow);
  newest_ = sequence;
}

std::uint8_t LossMeter::lostPercent() const {
  if (known_ == 0) return 0;
  return static_cast<std::uint8_t>((known_ - arrived_.count()) * 100 / known_);
}

}  // namespace platon
