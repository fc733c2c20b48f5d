#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "client/time/moment.h"
#include "client/time/quantile_window.h"
#include "client/time/slewing_clock.h"

namespace platon {

/// Decides which tick the client should be predicting. The server reports by how many ticks inputs of this client came
/// before they were needed (the slack). Every report becomes a sample of the lead over real time that the input would
/// have needed to be just in time; as it is computed from the lead the client had when it predicted that input, samples
/// do not depend on what the clock has done since, and a long round trip cannot make it swing.
///
/// The target is the 99th percentile of the last samples plus one tick: the measured jitter, losses included, and a
/// tick to spare. The clock slews towards it by at most 2 %. While it settles it does not go back, and jumps forward
/// when it is behind: the first reports cannot tell how late others will be. Else it jumps only when it is more than a
/// second off. A pure function of the times it is given.
class ClockSync {
 public:
  static constexpr double kMaxSlew = 0.02;
  static constexpr double kSpareTicks = 1.0;
  static constexpr double kJumpTicks = 60.0;
  static constexpr double kJumpWhileSettling = 0.25;  ///< ticks
  static constexpr std::uint32_t kSettlingReports = 64;

  /// `tick` is the one to have predicted up to at `now`.
  ClockSync(double tick, Moment now);

  /// Lets time pass. `now` never decreases.
  void update(Moment now);

  /// The tick to have predicted up to; steps back only in a jump.
  double tick() const { return clock_.tick(); }

  /// By what was heard at the time of the last update, the clock should show at least `tick`. Without effect once there
  /// was a report.
  void expect(double tick);
  bool reported() const { return reports_ > 0; }

  /// A report of the server: the input for `tick` came `slack` ticks before it was needed (negative: too late). Ticks
  /// older than 17 s, and those that a jump passed over, are ignored.
  void report(std::uint32_t tick, std::int32_t slack);

  /// Ticks that the clock is ahead (positive) or behind of its target; 0 before the first report.
  double error() const { return clock_.error(); }
  /// Spread of the samples: 99th percentile minus median, in ticks.
  double jitterTicks() const;
  std::uint32_t jumps() const { return clock_.jumps(); }

 private:
  static constexpr std::size_t kWindow = 256;    // samples: about 4 s at 60 reports a second
  static constexpr std::size_t kHistory = 1024;  // ticks

  struct Led {
    std::uint32_t tick = 0;
    bool known = false;
    double lead = 0;
  };

  bool settling() const { return reports_ <= kSettlingReports; }
  bool mayJump() const;
  void remember(double from, double to);

  SlewingClock clock_;
  std::uint32_t reports_ = 0;
  QuantileWindow<kWindow> samples_;
  std::array<Led, kHistory> history_{};  // by tick modulo kHistory
};

}  // namespace platon
