#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "client/desync/desync_detector.h"
#include "client/netcode/input_sender.h"
#include "client/netcode/interpolation_buffer.h"
#include "client/netcode/player_watch.h"
#include "client/netcode/prediction.h"
#include "client/netcode/prediction_clock.h"
#include "platon/game/game.h"
#include "protocol/full_state.h"
#include "protocol/moment.h"
#include "protocol/to_client.h"
#include "protocol/to_server.h"

namespace platon {

/// Returns the input of `slot` for the next tick of `predicted`. Called once per tick. When the player needs a restart
/// (EndlessFall), the round presses it too.
using Controls = std::function<Input(const Game& predicted, std::uint32_t slot)>;

/// Desyncs and resyncs of a client.
struct RoundStatistics {
  std::uint32_t desyncs = 0;  ///< times that the hash of the confirmed game differed from the server's
  std::uint32_t resyncs = 0;  ///< full states taken after the first confirmed ticks of a round
};

/// The client's side of one round, from the moment it has the level: keeps the confirmed game in lockstep with the
/// server, predicts ahead, and creates the messages with the local inputs.
class Round {
 public:
  /// `lead`: initial number of ticks that the prediction is ahead of the newest tick received.
  /// `observer` follows the confirmed game and must outlive the round; null: none.
  Round(std::uint32_t id, const std::shared_ptr<const Level>& level, std::uint32_t slot, double lead,
        ConfirmedObserver* observer = nullptr);

  std::uint32_t id() const { return id_; }
  const Prediction& prediction() const { return prediction_; }
  const RoundStatistics& statistics() const { return statistics_; }
  const PredictionClock& clock() const { return clock_; }
  /// Players of the confirmed game for drawing the others.
  const InterpolationBuffer& interpolationBuffer() const { return interpolationBuffer_; }
  /// Flashes by tick: of the confirmed game for the others, of the predicted game for the local player.
  const PlayerFlashes& flashes() const { return flashes_; }
  /// Of the local player in the predicted game.
  const EndlessFall& endlessFall() const { return endlessFall_; }
  const AttemptTime& attemptTime() const { return attemptTime_; }
  /// Position between two predicted ticks, for drawing the local player: 0 at `prediction().predictedBefore()` … 1 at
  /// `prediction().predicted()`.
  double predictedFraction() const;

  /// The desync that the last resync ended; each is returned once.
  std::optional<Desync> takeDesync() { return std::exchange(desync_, std::nullopt); }
  /// Call at the end of the round. Returns the desync that no resync has ended, if any.
  std::optional<Desync> endDesync() { return desyncDetector_.ended(); }

  /// Work (see Prediction) of the ticks that are confirmed between two calls of `advance`: further ones are ignored,
  /// and the server sends them again. The last tick may exceed it.
  static constexpr std::uint64_t kMaxWorkConfirmed = 4096;

  /// Handles a message of this round. Ticks that are confirmed already, or that leave a gap, are ignored.
  void receive(const ConfirmedTicks& message, Moment now);
  /// Handles a full state. `last`: the chunk that completes the state `bytes`. An invalid state is ignored.
  void receive(const StateChunk& last, std::span<const std::uint8_t> bytes);

  /// Replays the prediction if it was wrong, and predicts up to `now`.
  void advance(Moment now, const Controls& controls);

  /// The message to send at `now`, without its sequence number; nothing if none is due.
  std::optional<PlayerInputs> takeMessage(Moment now);

 private:
  bool applyTicks(const ConfirmedTicks& message);
  void observeOthers();
  void observeLocal();
  void checkHash(std::uint32_t serverHash);

  std::uint32_t id_;
  Prediction prediction_;
  PredictionClock clock_;
  InputSender inputSender_;
  InterpolationBuffer interpolationBuffer_;
  PlayerFlashes flashes_;
  EndlessFall endlessFall_;
  AttemptTime attemptTime_;
  std::uint8_t sync_ = 0;      // of the last full state taken
  std::uint32_t hash_ = 0;     // short hash of the confirmed game
  bool hashDiffered_ = false;  // the last hash differed from the server's
  DesyncDetector desyncDetector_;
  std::optional<Desync> desync_;
  RoundStatistics statistics_;
  ConfirmedObserver* observer_;                  // null: none
  std::uint64_t workLimit_ = kMaxWorkConfirmed;  // of prediction_, until the next `advance`
  std::vector<Input> inputs_;                    // scratch
};

}  // namespace platon
