#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "platon/game/game.h"
#include "platon/game/input.h"
#include "protocol/to_client.h"
#include "server/match/match_talk.h"

namespace platon {

/// Inputs of one player in one round, from their arrival until the server decides their tick. Ticks are decided in
/// order, one by one, whether or not their input has arrived.
class InputBuffer {
 public:
  /// Ticks for which inputs are accepted, from the next one to decide: about 2 s.
  static constexpr std::uint32_t kWindow = 128;
  /// Ticks without an input after which buttons count as released: 1 s.
  static constexpr std::uint32_t kHoldTicks = 60;

  /// `next` is the first tick to decide. The player is absent until its first input.
  explicit InputBuffer(std::uint32_t next = 0) : next_(next) {}

  /// Stores the input of a tick. False if the tick is decided, beyond the window, or already has an input; then at most
  /// missed() changes.
  bool add(std::uint32_t tick, Input input);

  /// Discards the inputs of undecided ticks. The last decided input stays in effect.
  void clear() { waiting_.fill(std::nullopt); }

  /// Decides tick `next()`: the input that arrived for it, otherwise the last decided one.
  Input decide();

  std::uint32_t next() const { return next_; }
  /// Ticks that were decided with another input than the one that arrived too late, by at most kWindow ticks. A client
  /// sends no input for most ticks in which nothing changes, so that one is lacking means nothing.
  std::uint64_t missed() const { return missed_; }

 private:
  void noteLate(std::uint32_t tick, Input input);
  std::optional<Input>& at(std::uint32_t tick) { return waiting_[tick % kWindow]; }

  std::array<std::optional<Input>, kWindow> waiting_{};  // ticks next_ … next_ + kWindow - 1
  std::array<Input, kWindow> decided_{};  // ticks next_ - kWindow … next_ - 1, or as they came too late
  std::uint32_t next_;
  Input last_;                           // decided last; absent until the first input
  std::uint32_t ticksWithoutInput_ = 0;  // since the last input
  std::uint64_t missed_ = 0;
};

/// Inputs of one player for consecutive ticks of a round, from a message.
struct TickInputs {
  std::uint32_t first = 0;  ///< tick of the first input
  std::span<const Input> inputs;

  std::uint32_t end() const { return first + static_cast<std::uint32_t>(inputs.size()); }
};

/// A player of the match: its slot and name, its inputs, whether it is active, and what it may say.
class MatchPlayer {
 public:
  /// Ticks without a changed button after which a player is inactive: 60 s.
  static constexpr std::uint64_t kActiveTicks = 60 * kTicksPerSecond;

  /// A player that joins at tick `now` of the match, counted over all rounds.
  MatchPlayer(std::uint32_t slot, std::string name, std::uint64_t now)
      : slot_(slot), name_(std::move(name)), activeAt_(now) {}

  std::uint32_t slot() const { return slot_; }
  const std::string& name() const { return name_; }
  void rename(std::string name) { name_ = std::move(name); }
  /// The name that a companion has asked for last; empty for a first player.
  const std::string& wanted() const { return wanted_; }
  void setWanted(std::string name) { wanted_ = std::move(name); }

  /// Starts a round, or one that is under way: ticks before `tick` are decided without the player.
  void startRound(std::uint32_t tick);
  /// Another client plays on: the inputs of undecided ticks are discarded.
  void resume();

  /// Stores inputs of the present round, of which `decided` ticks are decided, at tick `now` of the match. Returns how
  /// early the input came that SlackReport describes; nothing if no input is new.
  std::optional<SlackReport> addInputs(const TickInputs& inputs, std::uint32_t decided, std::uint64_t now);
  /// Decides the input of the next tick.
  Input decideInput() { return buffer_.decide(); }
  /// InputBuffer::missed of the round.
  std::uint64_t missedInputs() const { return buffer_.missed(); }

  /// The player has done something at tick `now` of the match.
  void noteActivity(std::uint64_t now) { activeAt_ = now; }
  /// Whether the player has changed a button, voted or joined in the last kActiveTicks. A button that is held for
  /// longer does not count, nor does the release of buttons for want of inputs.
  bool isActive(std::uint64_t now) const { return now - activeAt_ < kActiveTicks; }
  /// Whether the player may say something more at tick `now` of the match; it counts then.
  bool mayChat(std::uint64_t now) { return chatBudget_.take(now); }

 private:
  void forgetNewest();
  bool changesButtons(const TickInputs& inputs);
  std::uint32_t measuredTick(const TickInputs& inputs) const;

  std::uint32_t slot_;
  std::string name_;
  std::string wanted_;
  InputBuffer buffer_;
  std::uint32_t end_ = 0;     // one past the newest tick of the round for which an input has arrived
  Input newest_;              // for tick end_ - 1
  std::uint8_t buttons_ = 0;  // of the newest input of all rounds
  std::uint64_t activeAt_;    // tick of the match in which the player last changed a button, voted or joined
  ChatBudget chatBudget_ = ChatBudget::ofPlayers(1);
};

}  // namespace platon
