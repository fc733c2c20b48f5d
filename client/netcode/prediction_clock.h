#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "client/time/quantile_window.h"
#include "client/time/slewing_clock.h"
#include "protocol/time.h"
#include "protocol/to_client.h"

namespace platon {

/// Tells up to which tick the client must have predicted by now, so that its inputs reach the server just in time. It
/// counts ticks by real time, from the first ConfirmedTicks message of a round that shows the server's current tick.
/// The server reports by how many ticks inputs were early, their slack, and the clock follows the lead over real time
/// with which 99 % of the last 256 reported inputs would have been in time, plus one spare tick.
///
/// It slews by at most 2 %, and jumps if it is more than a second off. During the first 64 reports it never slews back,
/// and jumps forward when it is behind: they do not show yet how late other inputs will be. What a report asks for is
/// computed from the lead that the clock had when it passed that tick, so it does not depend on later changes of the
/// clock, and the clock does not oscillate on long round trips. A pure function of the messages and times passed in.
class PredictionClock {
 public:
  static constexpr double kMaxSlew = 0.02;
  static constexpr double kSpareTicks = 1.0;
  static constexpr double kJumpTicks = 60.0;
  static constexpr double kJumpTicksWhileSettling = 0.25;
  static constexpr std::uint32_t kSettlingReports = 64;
  /// Spare ticks of the initial lead: covers 100 ms of jitter, as none has been measured yet.
  static constexpr double kInitialSpareTicks = 7;

  /// `lead`: initial number of ticks ahead of the newest tick received.
  explicit PredictionClock(double lead) : lead_(lead) {}

  /// The initial lead of a client whose Hello was answered after `answerTime`.
  static double initialLead(Time answerTime) { return toTicks(answerTime) + kInitialSpareTicks; }

  /// Handles a ConfirmedTicks message of the round, even one without new ticks.
  void receive(const ConfirmedTicks& message, Time now);

  /// Advances to `now`, which never decreases. `next`: the first tick without a local input; all ticks that the clock
  /// reaches by now get their inputs together.
  void update(Time now, std::uint32_t next);
  /// Whether the input for `tick` must have been chosen by now.
  bool reaches(std::uint32_t tick) const { return clock_ && double{1} * tick + 1 <= clock_->tick(); }
  /// Call when the input for `tick` has been chosen.
  void inputChosen(std::uint32_t tick);

  /// First tick that gets a local input; the local player is absent before it. 0 until the clock runs.
  std::uint32_t firstInput() const { return firstInput_; }
  /// Whether the clock has started.
  bool running() const { return clock_.has_value(); }
  /// The tick that the client must have predicted; it decreases only in a jump. The clock must be running.
  double tick() const { return clock_->tick(); }
  /// Ticks ahead of the newest tick received; the initial lead until the first slack report.
  double lead() const { return lead_; }
  /// Slack of the last reported input, ticks; negative: too late. 0 before the first report.
  std::int32_t slack() const { return slack_; }
  /// Ticks ahead (positive) or behind of the target; 0 before the first slack report.
  double error() const { return clock_ ? clock_->error() : 0; }
  /// Spread of the samples: 99th percentile minus median, ticks.
  double jitterTicks() const;
  /// Jumps so far.
  std::uint32_t jumps() const { return clock_ ? clock_->jumps() : 0; }

 private:
  static constexpr std::size_t kWindow = 256;       // samples: about 4 s at 60 reports a second
  static constexpr std::size_t kHistory = 1024;     // ticks: 17 s
  static constexpr std::size_t kBatchWindow = 256;  // ticks

  // The lead with which the clock passed a tick.
  struct PastLead {
    std::uint32_t tick = 0;
    bool valid = false;
    double lead = 0;
  };

  void startOrAdvance(double tick, Time now);
  bool settling() const { return reports_ <= kSettlingReports; }
  void addReport(const SlackReport& report);
  void addSample(std::uint32_t tick, std::int32_t slack);
  void recordLead(double from, double to);

  std::optional<SlewingClock> clock_;  // empty until the first message
  double lead_;
  std::uint32_t firstInput_ = 0;
  std::int32_t slack_ = 0;

  std::uint32_t reports_ = 0;
  QuantileWindow<kWindow> samples_;
  std::array<PastLead, kHistory> pastLeads_{};  // by tick modulo kHistory

  std::uint32_t batchStart_ = 0;  // first tick of the current batch of inputs
  bool stalled_ = false;          // the last update came long after the one before
  std::array<std::uint32_t, kBatchWindow>
      batchOffsets_{};  // by tick modulo kBatchWindow: ticks since its batch's start
};

}  // namespace platon
