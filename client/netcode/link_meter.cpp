#include "client/netcode/link_meter.h"

namespace platon {

namespace {

constexpr int kSmoothing = 8;

}  // namespace

std::uint8_t LinkMeter::send(Moment now) {
  sentAt_[next_] = now;
  return next_++;
}

void LinkMeter::receive(const ConfirmedTicks& message, Moment now) {
  down_.received(message.sequence);
  if (!message.link) return;
  const std::uint8_t heard = message.link->sequence;
  const auto open = static_cast<std::uint8_t>(next_ - unheard_);
  // Told before, by a message that has overtaken this one, or never sent.
  if (static_cast<std::uint8_t>(heard - unheard_) >= open) return;
  unheard_ = static_cast<std::uint8_t>(heard + 1);
  lostUp_ = message.link->lostPercent;
  const Moment sample = now - sentAt_[heard];
  roundTrip_ = roundTrip_ == Moment{} ? sample : roundTrip_ + (sample - roundTrip_) / kSmoothing;
}

}  // namespace platon
