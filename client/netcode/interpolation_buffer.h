#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "client/netcode/player_snapshot.h"
#include "client/time/moment.h"
#include "client/time/quantile_window.h"
#include "client/time/slewing_clock.h"
#include "platon/game/game.h"

namespace platon {

/// The confirmed game as it is looked at: a little late, so that it moves evenly although its ticks come unevenly.
///
/// How late a tick came is known from real time. The view is behind the newest tick, when that comes as early as the
/// line has it, by
///
///     99th percentile of the lateness of the last 512 ticks + 1 tick + half a tick to spare,   30 ticks at most
///
/// the 1 because the view may leave a tick only when the next is there. It runs with real time, slewed towards that by
/// at most 5 %, and is never beyond the newest tick: when a tick comes later still, it waits, and is that much later
/// until it has caught up. (5 %, as nobody sees it, and a quarter of a second is made good within five.) It steps back
/// only in a jump. It jumps when it is more than half a second off, when more than half a second of ticks comes at
/// once, and when it starts anew; of ticks that come then only the newest is measured.
class InterpolationBuffer {
 public:
  static constexpr double kMaxSlew = 0.05;
  static constexpr double kSpareTicks = 0.5;
  static constexpr std::uint32_t kMaxDelay = 30;  ///< ticks
  static constexpr std::uint32_t kJumpTicks = 30;

  /// `confirmed` is the game after `ticks`, and nothing is known of those before.
  void restart(const Game& confirmed, std::uint32_t ticks);
  /// `confirmed` has been advanced by another tick.
  void advanced(const Game& confirmed);
  /// The ticks since the last call came at `now`, which never decreases.
  void arrived(Moment now);
  /// Lets time pass; `now` never decreases.
  void update(Moment now);

  /// The players as they are at `tick()`. Valid until `advanced` or `restart`.
  InterpolatedPlayers players() const;
  /// What is looked at: from one tick to the next, at most `newest()`.
  double tick() const;
  /// Ticks of the confirmed game.
  std::uint32_t newest() const { return newest_; }
  /// By how many ticks the view is to be behind a newest tick that comes as early as any; 0 while nothing has come.
  double targetDelay() const { return delay_; }
  /// Ticks that the view is ahead (positive) or behind of where it is to be.
  double error() const { return clock_ ? clock_->error() : 0; }
  std::uint32_t jumps() const { return jumps_; }

 private:
  static constexpr std::size_t kWindow = 512;  // ticks: 8.5 s
  static constexpr std::uint32_t kKept = 64;   // ticks; more than kMaxDelay + kJumpTicks

  std::vector<PlayerSnapshot>& at(std::uint32_t tick) { return kept_[tick % kKept]; }
  const std::vector<PlayerSnapshot>& at(std::uint32_t tick) const { return kept_[tick % kKept]; }
  void keep(const Game& confirmed);
  void measure(Moment now);
  void startClock(Moment now);
  double targetLead() const { return -earliest_ - delay_; }

  std::array<std::vector<PlayerSnapshot>, kKept> kept_;  // by tick modulo kKept, from oldest_ to newest_; by slot
  std::uint32_t oldest_ = 0;
  std::uint32_t newest_ = 0;
  std::uint32_t arrived_ = 0;         // newest_ at the last arrival
  QuantileWindow<kWindow> lateness_;  // 60 × real time − tick, when it came
  double earliest_ = 0;               // the least of it
  double delay_ = 0;
  std::optional<SlewingClock> clock_;  // none from a restart to the next arrival
  std::uint32_t jumps_ = 0;
};

}  // namespace platon
