#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "client/netcode/error_smoothing.h"
#include "client/time/moment.h"
#include "platon/game/game.h"
#include "platon/physics/unfold.h"

namespace platon {

/// How well the own player was predicted.
struct PredictionStatistics {
  std::uint32_t corrections = 0;
  std::int32_t maxSubunits = 0;    ///< distance of old and new prediction at the same tick, along the surface
  std::int32_t lastSubunits = 0;   ///< of the last correction
  std::uint32_t missedInputs = 0;  ///< ticks for which the server decided another own input than was predicted
  std::uint32_t mispredicted = 0;  ///< ticks after which the own player was not where it was predicted at first
  std::uint32_t confirmedTicks = 0;

  /// What has come since `before`; the largest and the last correction are those of `now`.
  friend PredictionStatistics operator-(const PredictionStatistics& now, const PredictionStatistics& before) {
    return {now.corrections - before.corrections,
            now.maxSubunits,
            now.lastSubunits,
            now.missedInputs - before.missedInputs,
            now.mispredicted - before.mispredicted,
            now.confirmedTicks - before.confirmedTicks};
  }
};

/// The two games of a client. The confirmed one moves in lockstep with the server by confirmed inputs alone. The
/// predicted one is a copy of it, replayed ahead with the own inputs that are not confirmed yet; the others are taken
/// to hold what they held last. It is replayed only when something confirmed differs from what was predicted.
///
/// A tick here is one call of Game::advance in this round; a game that is over counts them no more, this class does.
class Prediction {
 public:
  /// Ticks that the prediction may be ahead of what is confirmed: more than four seconds.
  static constexpr std::uint32_t kMaxAhead = 256;

  /// `start` is the server's game after 0 ticks, `slot` (below kMaxPlayers) the own player's.
  Prediction(const Game& start, std::uint32_t slot);

  /// Whether the next tick may be predicted: fewer than kMaxAhead are.
  bool mayPredict() const { return predictedTicks_ - confirmedTicks_ < kMaxAhead; }
  /// Predicts the next tick with these buttons, where it may.
  void predict(Input own);

  /// The server's decision on tick `confirmedTicks()`, by slot. At most kMaxPlayers.
  void confirm(std::span<const Input> inputs);
  /// Replaces the confirmed game by the server's after `ticks`, in whose last tick the slots did `held`. False, and
  /// nothing changed, when the state is no valid one.
  bool restore(std::span<const std::uint8_t> state, std::uint32_t ticks, std::span<const Input> held);
  /// Replays what has been predicted where that is needed; to be called after a batch of `confirm` or `restore`.
  void reconcile(Moment now);

  const Game& confirmed() const { return confirmed_; }
  const Game& predicted() const { return predicted_; }
  std::uint32_t confirmedTicks() const { return confirmedTicks_; }
  std::uint32_t predictedTicks() const { return predictedTicks_; }
  std::uint32_t slot() const { return slot_; }
  /// What the server decided last, by slot; absent beyond its end.
  std::span<const Input> held() const { return held_; }
  /// The predicted world's entities one tick before `predicted()`.
  std::span<const EntityState> predictedBefore() const { return predictedBefore_; }
  /// The server has let the own player in.
  bool present() const;

  /// The own input predicted for `tick`, from confirmedTicks() to just before predictedTicks().
  Input ownInput(std::uint32_t tick) const { return own_[tick % kMaxAhead]; }

  const PredictionStatistics& count() const { return count_; }
  /// What is to be added to the own player's predicted position to hide corrections: subunits, in the player's frame.
  Point smoothing(Moment now) const { return fade_.at(now); }

 private:
  void hold(std::span<const Input> inputs);
  std::optional<Place> ownPlace(const Game& game) const;
  void judge();
  void replay(std::uint32_t until);
  void advancePredicted(Input own);
  void compare(const Place& before, Moment now);

  std::uint32_t slot_;
  Game confirmed_;
  Game predicted_;
  std::uint32_t confirmedTicks_ = 0;
  std::uint32_t predictedTicks_ = 0;
  bool stale_ = false;                                   // what is confirmed is not what was predicted
  std::array<Input, kMaxAhead> own_{};                   // by tick modulo kMaxAhead
  std::array<std::optional<Place>, kMaxAhead> first_{};  // own place after it as predicted at first, likewise
  std::vector<Input> held_;                              // has slot_ always
  std::vector<Input> inputs_;                            // scratch
  std::vector<EntityState> predictedBefore_;
  PredictionStatistics count_;
  ErrorSmoothing fade_;
};

}  // namespace platon
