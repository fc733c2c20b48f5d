#pragma once

#include <array>
#include <cstddef>
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
#include "protocol/time.h"
#include "protocol/to_client.h"
#include "protocol/to_server.h"
#include "protocol/transfer.h"

namespace platon {

/// Returns the input of the local player in `slot` for the next tick of `predicted`. Called once per tick for each
/// local player. When the player needs a restart (EndlessFall), the round presses it too.
using Controls = std::function<Input(const Game& predicted, std::uint32_t slot)>;

/// Desyncs and resyncs of a client.
struct RoundStatistics {
  std::uint32_t desyncs = 0;  ///< times that the hash of the confirmed game differed from the server's
  std::uint32_t resyncs = 0;  ///< full states taken after the first confirmed ticks of a round
};

/// What a client exchanges with the server in one round, whether it has the game or not: it takes the messages of the
/// round, chooses the local inputs when their tick is due, and creates the messages with them.
class RoundExchange {
 public:
  /// `lead`: initial number of ticks ahead of the newest tick received.
  RoundExchange(std::uint32_t id, double lead) : id_(id), clock_(lead), inputSender_(id) {}

  std::uint32_t id() const { return id_; }
  const PredictionClock& clock() const { return clock_; }

  /// Handles ConfirmedTicks. Returns whether its ticks are to be confirmed after the first `confirmed` ones: not those
  /// of another round, those that are confirmed already, and those that leave a gap.
  bool receive(const ConfirmedTicks& message, std::uint32_t confirmed, Time now);
  /// Handles a chunk of a full state. Returns the state if the chunk completes it.
  std::optional<std::vector<std::uint8_t>> receive(const StateChunk& chunk);

  /// Advances the clock to `now`. `next`: the first tick without local inputs.
  void update(Time now, std::uint32_t next) { clock_.update(now, next); }
  /// Whether the inputs for `tick` must have been chosen by now.
  bool isDue(std::uint32_t tick) const { return clock_.reaches(tick); }
  /// The local inputs for `tick`, which are due and are sent with the next messages: what `inputs` returns. Nobody is
  /// present in ticks before the first with local inputs.
  InputsByLocal choose(std::uint32_t tick, const std::function<InputsByLocal()>& inputs);

  /// Another player has this local number now.
  void forget(std::size_t local) { inputSender_.forget(local); }
  /// Makes the next message due at once.
  void sendSoon() { inputSender_.sendSoon(); }
  /// The message to send at `now`, without its sequence number; nothing if none is due.
  std::optional<PlayerInputs> takeMessage(Time now, const ConfirmedState& confirmed) {
    return inputSender_.takeMessage(now, confirmed);
  }

 private:
  std::uint32_t id_;
  PredictionClock clock_;
  InputSender inputSender_;
  Assembly state_;
};

/// The client's side of one round, from the moment it has the level: keeps the confirmed game in lockstep with the
/// server, predicts ahead with the inputs of its RoundExchange, and notes what is drawn of the players.
class Round {
 public:
  /// `slots`: of the local players. `lead`: initial number of ticks that the prediction is ahead of the newest tick
  /// received. `observer` follows the confirmed game and must outlive the round; null: none.
  Round(std::uint32_t id, const std::shared_ptr<const Level>& level, const SlotsByLocal& slots, double lead,
        ConfirmedObserver* observer = nullptr);

  /// Companions have come or left.
  void setSlots(const SlotsByLocal& slots);

  std::uint32_t id() const { return exchange_.id(); }
  const Prediction& prediction() const { return prediction_; }
  const RoundStatistics& statistics() const { return statistics_; }
  const PredictionClock& clock() const { return exchange_.clock(); }
  /// Players of the confirmed game for drawing the others.
  const InterpolationBuffer& interpolationBuffer() const { return interpolationBuffer_; }
  /// Flashes by tick: of the confirmed game for the others, of the predicted game for the local players.
  const PlayerFlashes& flashes() const { return flashes_; }
  /// Of a local player in the predicted game.
  const EndlessFall& endlessFall(std::size_t local = 0) const { return attempts_[local].fall; }
  const AttemptTime& attemptTime(std::size_t local = 0) const { return attempts_[local].time; }
  /// Of all players in the predicted game, as one (teamOf).
  const AttemptTime& teamTime() const { return teamTime_; }
  /// Position between two predicted ticks, for drawing the local players: 0 at `prediction().predictedBefore()` … 1 at
  /// `prediction().predicted()`.
  double predictedFraction() const;

  /// The desync that the last resync ended; each is returned once.
  std::optional<Desync> takeDesync() { return std::exchange(desync_, std::nullopt); }
  /// Call at the end of the round. Returns the desync that no resync has ended, if any.
  std::optional<Desync> endDesync() { return desyncDetector_.ended(); }

  /// Work (see Prediction) of the ticks that are confirmed between two calls of `advance`: further ones are ignored,
  /// and the server sends them again. The last tick may exceed it.
  static constexpr std::uint64_t kMaxWorkConfirmed = 4096;

  /// Ticks of another round, that are confirmed already, or that leave a gap, are ignored.
  void receive(const ConfirmedTicks& message, Time now);
  /// Takes a chunk of a full state of this round. Returns whether it completes the state. An invalid one is ignored.
  bool receive(const StateChunk& chunk);

  /// Replays the prediction if it was wrong, and predicts up to `now`.
  void advance(Time now, const Controls& controls);

  /// The message to send at `now`, without its sequence number; nothing if none is due.
  std::optional<PlayerInputs> takeMessage(Time now);

 private:
  // Of a local player.
  struct Attempt {
    EndlessFall fall;
    AttemptTime time;
  };

  void restore(const StateChunk& last, std::span<const std::uint8_t> bytes);
  bool applyTicks(const ConfirmedTicks& message);
  void observeOthers();
  void observeLocal();
  InputsByLocal buttons(const Controls& controls) const;
  void checkHash(std::uint32_t serverHash);

  RoundExchange exchange_;
  Prediction prediction_;
  InterpolationBuffer interpolationBuffer_;
  PlayerFlashes flashes_;
  std::array<Attempt, kMaxLocalPlayers> attempts_;  // by local number
  AttemptTime teamTime_;
  std::uint8_t sync_ = 0;   // of the last full state taken
  std::uint32_t hash_ = 0;  // short hash of the confirmed game
  DesyncDetector desyncDetector_;
  std::optional<Desync> desync_;
  RoundStatistics statistics_;
  ConfirmedObserver* observer_;                  // null: none
  std::uint64_t workLimit_ = kMaxWorkConfirmed;  // of prediction_, until the next `advance`
  std::vector<Input> inputs_;                    // scratch
};

}  // namespace platon
