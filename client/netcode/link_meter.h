#pragma once

#include <array>
#include <cstdint>

#include "client/time/moment.h"
#include "protocol/loss_meter.h"
#include "protocol/to_client.h"

namespace platon {

/// What the line of a session is like, measured by the messages of every tick.
class LinkMeter {
 public:
  /// The number for the message of inputs that is sent now.
  std::uint8_t send(Moment now);
  void receive(const ConfirmedTicks& message, Moment now);

  /// Smoothed over some ten messages. From an input's departure until ticks come that were decided after it arrived: it
  /// includes what the server waits for its next tick and its next message.
  Moment roundTrip() const { return roundTrip_; }
  /// Of the last hundred messages of ticks, 0 … 100.
  std::uint32_t lostDownPercent() const { return down_.lostPercent(); }
  /// Of the last hundred messages of inputs, as the server says, 0 … 100.
  std::uint32_t lostUpPercent() const { return lostUp_; }

 private:
  std::array<Moment, 256> sentAt_{};  // by number
  std::uint8_t next_ = 0;
  std::uint8_t unheard_ = 0;  // the oldest number that the server has not told of
  LossMeter down_;
  std::uint32_t lostUp_ = 0;
  Moment roundTrip_{};
};

}  // namespace platon
