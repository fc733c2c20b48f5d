#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "client/netcode/player_snapshot.h"
#include "client/time/quantile_window.h"
#include "client/time/slewing_clock.h"
#include "platon/game/game.h"
#include "protocol/time.h"

namespace platon {

/// Buffers the players of the confirmed game and plays them back with a delay, so that they move evenly although ticks
/// arrive unevenly.
///
/// The lateness of a tick is its arrival time minus its time on the server, up to a constant. The target delay of the
/// playback behind a newest tick that arrived with minimum lateness is
///
///     99th percentile − minimum of the lateness of the last 512 ticks + 1 tick + 0.5 spare ticks,  at most 30 ticks
///
/// One tick is needed because the interpolation between two ticks can start only when the second has arrived. The
/// playback clock slews by at most 5 %, which is not noticeable, so it makes up 0.25 s within 5 s. It never passes the
/// newest tick: if the next tick is later still, the playback stops and catches up afterwards. It jumps after a
/// restart, when it is more than 30 ticks off, and when more than 30 ticks arrive at once; then only the
/// lateness of the newest of these ticks is measured.
class InterpolationBuffer {
 public:
  static constexpr double kMaxSlew = 0.05;
  static constexpr double kSpareTicks = 0.5;
  static constexpr std::uint32_t kMaxDelay = 30;  ///< ticks
  static constexpr std::uint32_t kJumpTicks = 30;

  /// Discards all ticks. `confirmed` is the game after `ticks`.
  void restart(const Game& confirmed, std::uint32_t ticks);
  /// `confirmed` has been advanced by one tick.
  void advanced(const Game& confirmed);
  /// Call when the ticks added since the last call have arrived at `now`, which never decreases.
  void arrived(Time now);
  /// Advances the playback to `now`, which never decreases.
  void update(Time now);

  /// The players at `tick()`. Valid until `advanced` or `restart`.
  InterpolatedPlayers players() const;
  /// Position of the playback, at most `newest()`. Fractional between two ticks.
  double tick() const;
  /// Newest tick in the buffer.
  std::uint32_t newest() const { return newest_; }
  /// Target delay behind a newest tick with minimum lateness, ticks; 0 before the first arrival.
  double targetDelay() const { return delay_; }
  /// Ticks that the playback is ahead (positive) or behind of its target.
  double error() const { return clock_ ? clock_->error() : 0; }
  std::uint32_t jumps() const { return jumps_; }

 private:
  static constexpr std::size_t kWindow = 512;         // ticks: 8.5 s
  static constexpr std::uint32_t kMaxSnapshots = 64;  // ticks; more than kMaxDelay + kJumpTicks

  std::vector<PlayerSnapshot>& at(std::uint32_t tick) { return snapshots_[tick % kMaxSnapshots]; }
  const std::vector<PlayerSnapshot>& at(std::uint32_t tick) const { return snapshots_[tick % kMaxSnapshots]; }
  void keepNewest(const Game& confirmed);
  void measure(Time now);
  void startClock(Time now);
  double targetLead() const { return -minLateness_ - delay_; }

  std::array<std::vector<PlayerSnapshot>, kMaxSnapshots>
      snapshots_;  // oldest_ … newest_, by tick modulo kMaxSnapshots; by slot
  std::uint32_t oldest_ = 0;
  std::uint32_t newest_ = 0;
  std::uint32_t arrived_ = 0;         // newest_ at the last arrival
  QuantileWindow<kWindow> lateness_;  // 60 × arrival time − tick
  double minLateness_ = 0;
  double delay_ = 0;
  std::optional<SlewingClock> clock_;  // empty from a restart to the next arrival
  std::uint32_t jumps_ = 0;
};

}  // namespace platon
