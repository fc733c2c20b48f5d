#pragma once

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "client/netcode/input_sender.h"
#include "platon/exact/point.h"
#include "platon/game/game.h"
#include "platon/game/input.h"
#include "platon/physics/unfold.h"
#include "protocol/time.h"
#include "protocol/to_client.h"

namespace platon {

/// Follows the confirmed game of a client, which is the server's, tick by tick. It only watches.
class ConfirmedObserver {
 public:
  virtual ~ConfirmedObserver() = default;
  /// The confirmed game is another one: at the start of a round, and after a full state of the server. `slot` is the
  /// local player's.
  virtual void began(const Game& confirmed, std::uint32_t slot) = 0;
  /// `confirmed` has been advanced by `inputs`.
  virtual void advanced(std::span<const Input> inputs, const Game& confirmed) = 0;
};

/// Hides corrections of the local player's prediction: the offset between drawn and predicted position. Each correction
/// fades linearly to zero within 100 ms. Offsets are in the player's own frame, so that crossing an edge does not
/// disturb them.
///
/// At most one correction comes with each of the server's 60 messages per second: 6 within 100 ms, more after a stall.
/// If more than kMaxCorrections are fading, the oldest is dropped.
class ErrorSmoothing {
 public:
  static constexpr Time kDuration = std::chrono::milliseconds(100);
  static constexpr std::size_t kMaxCorrections = 32;

  /// Adds a correction made at `now`, which never decreases. `offset`: old minus new position, subunits, in the
  /// player's own frame.
  void add(Point offset, Time now);
  /// The offset to add to the predicted position at `now`. Each fading correction is rounded towards zero.
  Point at(Time now) const;
  void clear() { count_ = 0; }

 private:
  struct Correction {
    Point offset;
    Time start{};

    Time remaining(Time now) const;
    Point at(Time now) const;
  };

  void dropOldest();

  std::array<Correction, kMaxCorrections> corrections_;  // the first count_ are fading, oldest first
  std::size_t count_ = 0;
};

/// Accuracy of the prediction of the local players.
struct PredictionStatistics {
  std::uint32_t corrections = 0;
  std::int32_t maxSubunits = 0;    ///< largest correction: distance of old and new prediction along the surface
  std::int32_t lastSubunits = 0;   ///< last correction
  std::uint32_t missedInputs = 0;  ///< local inputs other than which the server has decided
  std::uint32_t mispredicted = 0;  ///< ticks of a local player whose confirmed position is not the one first predicted
  std::uint32_t confirmedTicks = 0;

  /// The counts gained since `before`; `maxSubunits` and `lastSubunits` stay those of `now`.
  friend PredictionStatistics operator-(const PredictionStatistics& now, const PredictionStatistics& before) {
    return {now.corrections - before.corrections,
            now.maxSubunits,
            now.lastSubunits,
            now.missedInputs - before.missedInputs,
            now.mispredicted - before.mispredicted,
            now.confirmedTicks - before.confirmedTicks};
  }
};

/// The two games of a client. The confirmed game runs in lockstep with the server, with confirmed inputs only. The
/// predicted game is a copy of it advanced with the unconfirmed inputs of the local players; the other players are
/// assumed to keep their last confirmed input. Reconciliation replays it only if a confirmed input or state differs
/// from the prediction.
///
/// Ticks are calls of Game::advance in this round.
class Prediction {
 public:
  /// Maximum number of predicted ticks ahead of the confirmed game: more than 4 s.
  static constexpr std::uint32_t kMaxAhead = 256;
  /// Maximum work of these ticks. With more than 64 players, fewer ticks are predicted.
  static constexpr std::uint32_t kMaxWorkAhead = 16384;

  /// `start`: the server's game after 0 ticks. `slots`: of the local players, as LocalSlots::slots.
  Prediction(const Game& start, const SlotsByLocal& slots);

  /// Companions have come or left. Call `reconcile` after it.
  void setSlots(const SlotsByLocal& slots);

  /// Whether `predict` may be called.
  bool mayPredict() const { return predictedTicks_ - confirmedTicks_ < maxAhead(); }
  /// Predicts one tick with these local inputs. A local player that is not present in them keeps its confirmed input.
  void predict(const InputsByLocal& local);

  /// Advances the confirmed game by the server's inputs for tick `confirmedTicks()`, by slot. At most kMaxPlayers.
  void confirm(std::span<const Input> inputs);
  /// Replaces the confirmed game by the server's state after `ticks` ticks; the last of these ticks had the
  /// inputs `held`. Returns false and changes nothing if the state is invalid.
  bool restore(std::span<const std::uint8_t> state, std::uint32_t ticks, std::span<const Input> held);
  /// Replays the prediction where needed. Call after a batch of `confirm` or `restore`.
  void reconcile(Time now);

  const Game& confirmed() const { return confirmed_; }
  const Game& predicted() const { return predicted_; }
  std::uint32_t confirmedTicks() const { return confirmedTicks_; }
  std::uint32_t predictedTicks() const { return predictedTicks_; }
  /// Of the first local player.
  std::uint32_t slot() const { return *slots_[0]; }
  /// Of all local players.
  const SlotsByLocal& slots() const { return slots_; }
  /// Whether a local player has this slot.
  bool isLocal(std::uint32_t slot) const { return std::find(slots_.begin(), slots_.end(), slot) != slots_.end(); }
  /// Last confirmed inputs, by slot. Slots beyond the end are absent.
  std::span<const Input> held() const { return held_; }
  /// Entities of the predicted world one tick before `predicted()`.
  std::span<const EntityState> predictedBefore() const { return predictedBefore_; }
  /// Whether the first local player is present in the confirmed game.
  bool present() const { return isPresent(slot()); }

  /// The local inputs predicted for `tick`, which is in confirmedTicks() … predictedTicks() − 1.
  const InputsByLocal& localInputs(std::uint32_t tick) const { return localInputs_[tick % kMaxAhead]; }

  /// Work so far: ticks of both games, replayed ones included, each counted once per player. A player costs at most 50
  /// µs a tick, in usual levels about 1 µs.
  std::uint64_t work() const { return work_; }
  const PredictionStatistics& statistics() const { return statistics_; }
  /// Offset to add to the predicted position of a local player to hide corrections: subunits, in its own frame.
  Point smoothing(std::size_t local, Time now) const { return smoothing_[local].at(now); }

 private:
  std::uint32_t maxAhead() const;
  using PlacesByLocal = std::array<std::optional<Place>, kMaxLocalPlayers>;

  bool isPresent(std::uint32_t slot) const;
  void hold(std::span<const Input> inputs);
  void holdLocal(const InputsByLocal& local, std::vector<Input>& inputs) const;
  PlacesByLocal localPlaces(const Game& game) const;
  void countMissed(std::span<const Input> inputs);
  void countMispredictions();
  void replay(std::uint32_t until);
  void advancePredicted(const InputsByLocal& local);
  void correct(std::size_t local, const Place& before, const Place& after, Time now);

  SlotsByLocal slots_;
  Game confirmed_;
  Game predicted_;
  std::uint32_t confirmedTicks_ = 0;
  std::uint32_t predictedTicks_ = 0;
  bool stale_ = false;                                   // the confirmed game differs from the predicted one
  std::array<InputsByLocal, kMaxAhead> localInputs_{};   // by tick modulo kMaxAhead
  std::array<PlacesByLocal, kMaxAhead> firstPredicted_;  // local positions after the tick, likewise
  std::vector<Input> held_;                              // always contains slots_
  std::uint32_t players_ = 1;                            // local ones, and others in held_
  std::uint64_t work_ = 0;
  std::vector<Input> inputs_;  // scratch
  std::vector<EntityState> predictedBefore_;
  PredictionStatistics statistics_;
  std::array<ErrorSmoothing, kMaxLocalPlayers> smoothing_;
};

}  // namespace platon
