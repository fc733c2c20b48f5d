#include "protocol/loss_meter.h"

#include <algorithm>

namespace platon {

void LossMeter::heard(std::uint8_t sequence) {
  const auto ahead = static_cast<std::int8_t>(static_cast<std::uint8_t>(sequence - newest_));
  if (known_ == 0) {
    known_ = 1;
    arrived_.set(0);
    newest_ = sequence;
  } else if (ahead > 0) {
    const auto steps = static_cast<std::size_t>(ahead);
    arrived_ <<= steps;
    arrived_.set(0);
    known_ = std::min(known_ + steps, kWindow);
    newest_ = sequence;
  } else if (const auto back = static_cast<std::size_t>(-ahead); back < known_) {
    arrived_.set(back);
  }
}

std::uint8_t LossMeter::lostPercent() const {
  if (known_ == 0) return 0;
  return static_cast<std::uint8_t>((known_ - arrived_.count()) * 100 / known_);
}

}  // namespace platon
