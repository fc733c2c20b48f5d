#pragma once

#include <array>
#include <cstdint>

#include "client/netcode/prediction_clock.h"
#include "protocol/loss_meter.h"
#include "protocol/time.h"
#include "protocol/to_client.h"

namespace platon {

/// Quality of a connection in display units.
struct LinkStatistics {
  double rttMs = 0;            ///< smoothed; includes the server's wait for its next tick and message
  double jitterMs = 0;         ///< of messages to the server: 99th percentile minus median of their lateness
  double slackTicks = 0;       ///< ticks by which the last reported input was early; negative: too late
  double lostDownPercent = 0;  ///< of the last hundred messages
  double lostUpPercent = 0;
};

/// Measures round trip and loss of a connection from the sequence numbers of PlayerInputs and ConfirmedTicks.
class LinkMeter {
 public:
  /// Returns the sequence number for a PlayerInputs message sent at `now`.
  std::uint8_t nextSequence(Time now);
  void receive(const ConfirmedTicks& message, Time now);

  /// Time from sending an input to receiving ticks decided after it arrived, so it includes the server's wait for its
  /// next tick and message. Smoothed over about 8 messages; 0 before the first.
  Time roundTrip() const { return roundTrip_; }
  /// Lost messages among the last hundred from the server, per cent.
  std::uint32_t lostDownPercent() const { return down_.lostPercent(); }
  /// Lost messages among the last hundred to the server, as it reports them, per cent.
  std::uint32_t lostUpPercent() const { return lostUp_; }
  /// `clock`: null while no round runs; jitter and slack are 0 then.
  LinkStatistics statistics(const PredictionClock* clock) const;

 private:
  std::array<Time, 256> sentAt_{};  // by sequence number
  std::uint8_t next_ = 0;
  std::uint8_t oldestPending_ = 0;  // the server has not reported this number or a later one
  LossMeter down_;
  std::uint32_t lostUp_ = 0;
  Time roundTrip_{};
};

}  // namespace platon
