#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "client/desync/desync_detector.h"
#include "client/netcode/clock_sync.h"
#include "client/netcode/flashes.h"
#include "client/netcode/input_clock.h"
#include "client/netcode/interpolation_buffer.h"
#include "client/netcode/prediction.h"
#include "client/netcode/report_schedule.h"
#include "client/time/moment.h"
#include "platon/game/game.h"
#include "protocol/full_state.h"
#include "protocol/to_client.h"
#include "protocol/to_server.h"

namespace platon {

/// Chooses the buttons of slot `slot` for the next tick of `predicted`; asked once for every tick.
using Controls = std::function<Input(const Game& predicted, std::uint32_t slot)>;

/// How well a client keeps in step with the server.
struct RoundStatistics {
  std::uint32_t desyncs = 0;  ///< the confirmed game was not the server's
  std::uint32_t resyncs = 0;  ///< full states taken after the first ticks of the round were confirmed
};

/// One round as a client lives it, from when it has the level: keeps the confirmed game in lockstep, the prediction as
/// far ahead as the line demands, and says what to tell the server.
class Round {
 public:
  /// `lead`: ticks that a client must be ahead of the newest tick it hears of, as far as is known.
  Round(std::uint32_t id, const std::shared_ptr<const Level>& level, std::uint32_t slot, double lead);

  std::uint32_t id() const { return id_; }
  const Prediction& prediction() const { return prediction_; }
  const RoundStatistics& count() const { return count_; }
  /// What was wrong with the confirmed game when the server's state last replaced it; each is given once.
  std::optional<Desync> takeDesync() { return std::exchange(desync_, std::nullopt); }
  /// Nothing more is received in this round: what is wrong with the confirmed game and has not been put right.
  std::optional<Desync> abandonedDesync() { return watch_.abandoned(); }
  /// None until the first ticks have been confirmed.
  const std::optional<ClockSync>& clock() const { return clock_.sync(); }
  /// Ticks that the prediction is ahead of the newest tick heard of; what was given while there is no clock.
  double lead() const { return clock_.lead(); }

  /// Messages of this round. What is not news is ignored.
  void receive(const ConfirmedTicks& message, Moment now);
  /// `bytes`: what the pieces that `last` completes make together.
  void receive(const StateChunk& last, std::span<const std::uint8_t> bytes, Moment now);

  /// Predicts up to `now`.
  void advance(Moment now, const Controls& controls);

  /// What to send to the server now, if anything, as ReportSchedule has it. All that is not confirmed is repeated every
  /// time.
  std::optional<PlayerInputs> report(Moment now);
  /// By how many ticks an own input last came before the server needed it; 0 before the first report.
  std::int32_t slack() const { return clock_.slack(); }

  /// For drawing the others.
  const InterpolationBuffer& interpolationBuffer() const { return view_; }
  /// By ticks of the confirmed game for the others, of the predicted one for the own player.
  const Flashes& flashes() const { return flashes_; }
  /// For drawing the own player: how far to have moved on from `prediction().predictedBefore()`, 0 … 1.
  double predictedFraction() const;

 private:
  void apply(const ConfirmedTicks& message);
  void watchOthers();
  void watchOwn();
  void check(std::uint32_t hash);

  std::uint32_t id_;
  Prediction prediction_;
  InputClock clock_;
  ReportSchedule schedule_;
  std::uint8_t sync_ = 0;
  std::uint32_t hash_ = 0;  // short, of the confirmed game
  bool outOfStep_ = false;  // the last hash did not match
  DesyncDetector watch_;
  std::optional<Desync> desync_;
  std::vector<Input> inputs_;  // scratch

  InterpolationBuffer view_;
  Flashes flashes_;
  RoundStatistics count_;
};

}  // namespace platon
