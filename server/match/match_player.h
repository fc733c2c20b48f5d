#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "platon/game/game.h"
#include "platon/game/input.h"
#include "protocol/loss_meter.h"
#include "protocol/session_token.h"
#include "protocol/to_client.h"
#include "protocol/to_server.h"
#include "protocol/transport/socket_address.h"
#include "server/match/match_talk.h"
#include "server/match/transfers.h"
#include "server/match/updates.h"

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

/// The inputs that a client sends in a round, and how well they arrive: what is lost, and how early the rest comes.
class ClientInputs {
 public:
  /// Starts a round, or one that is under way: ticks before `tick` are decided without the player.
  void startRound(std::uint32_t tick);
  /// Starts again for another client.
  void resume();

  /// Counts a message of inputs, of any round, for the link report.
  void countMessage(std::uint8_t sequence);
  /// Stores the inputs of a message of the current round, of which `decided` ticks are decided. Returns whether a
  /// button has changed. A button that is held does not count.
  bool add(const PlayerInputs& message, std::uint32_t decided);
  /// Decides the input of the next tick.
  Input decide() { return buffer_.decide(); }
  /// InputBuffer::missed of the round.
  std::uint64_t missed() const { return buffer_.missed(); }
  /// Link report since the last call; nothing if no message of inputs has arrived.
  std::optional<LinkReport> takeLinkReport();

 private:
  void forgetNewest();
  void measureSlack(const PlayerInputs& message, std::uint32_t decided);
  bool changesButtons(const PlayerInputs& message);
  std::uint32_t measuredTick(const PlayerInputs& message) const;

  InputBuffer buffer_;
  LossMeter loss_;  // of the messages of inputs
  std::optional<LinkReport> linkReport_;
  std::uint32_t end_ = 0;     // one past the newest tick of the round for which an input has arrived
  Input newest_;              // for tick end_ - 1
  std::uint8_t buttons_ = 0;  // of the newest input of all rounds
};

/// Whether a player wishes the next level. The player may change its mind at any time. What counts follows its last
/// wish, but changes at most once in kMinTicks, so that a flood of votes does not make the counts of others flicker.
class VoteWish {
 public:
  static constexpr std::uint64_t kMinTicks = kTicksPerSecond;

  void set(bool next) { last_ = next; }
  /// No wish, from now on.
  void clear() { last_ = counts_ = false; }
  /// Whether the wish counts at tick `now` of the match, which never decreases.
  bool counts(std::uint64_t now) {
    if (last_ != counts_ && now >= changeableAt_) {
      counts_ = last_;
      changeableAt_ = now + kMinTicks;
    }
    return counts_;
  }

 private:
  bool last_ = false;
  bool counts_ = false;
  std::uint64_t changeableAt_ = 0;
};

/// A player of the match and what the server knows of its client: who it is and where, its inputs, the ticks that it
/// has, the transfers to it. A client may lose its connection; another one can resume the player then.
class MatchPlayer {
 public:
  /// Ticks without a changed button after which a player is inactive: 60 s.
  static constexpr std::uint64_t kActiveTicks = 60 * kTicksPerSecond;

  /// A player that joins at tick `now` of the match, counted over all rounds.
  MatchPlayer(std::uint32_t slot, std::string name, const std::optional<SessionToken>& token, std::uint64_t now)
      : slot_(slot), name_(std::move(name)), token_(token), activeAt_(now) {}

  std::uint32_t slot() const { return slot_; }
  const std::string& name() const { return name_; }
  /// Whether the player joined with this token.
  bool hasToken(const SessionToken& token) const { return token_ && sameToken(*token_, token); }
  /// Whether a client can resume the player, that is, whether it joined with a token.
  bool canResume() const { return token_.has_value(); }
  /// Address that the client is at, or was at last.
  const IpAddress& address() const { return address_; }
  /// Household of this address.
  std::uint64_t origin() const { return address_.household(); }
  void setAddress(const IpAddress& address) { address_ = address; }

  /// Resumes the player for another client. That client has received nothing that was sent to the previous one.
  void resume(std::string name);
  /// Starts a new round. A transfer of a state of the old round is cancelled.
  void startRound();

  /// Stores the inputs of a message of the current round. `decided`: number of decided ticks of the round; `now`: tick
  /// of the match. Returns how many of the inputs are missed ones (InputBuffer::missed).
  std::uint64_t addInputs(const PlayerInputs& message, std::uint32_t decided, std::uint64_t now);
  /// Whether the message reports the client's current progress: the client has restored the last state sent, and the
  /// message is not older than another one received.
  bool isCurrent(const PlayerInputs& message) const;
  /// Whether the client has changed a button, voted or joined in the last kActiveTicks. A button that is held for
  /// longer does not count, nor does the release of buttons for want of inputs.
  bool isActive(std::uint64_t now) const { return now - activeAt_ < kActiveTicks; }
  /// The player wishes the next level, or no longer wishes it. The wish ends with the round and with the connection.
  void vote(bool next, std::uint64_t now);
  /// Whether this wish counts now (VoteWish).
  bool wishesNext(std::uint64_t now) { return wish_.counts(now); }
  /// Whether the player may say something more at tick `now` of the match; it counts then.
  bool mayChat(std::uint64_t now) { return chatBudget_.take(now); }

  ClientInputs& inputs() { return inputs_; }
  const ClientInputs& inputs() const { return inputs_; }
  TickDelivery& ticks() { return ticks_; }
  const TickDelivery& ticks() const { return ticks_; }
  ClientTransfers& transfers() { return transfers_; }

 private:
  std::uint32_t slot_;
  std::string name_;
  std::optional<SessionToken> token_;
  IpAddress address_;
  std::uint64_t activeAt_;  // tick of the match in which the client last changed a button, voted or joined
  VoteWish wish_;
  ChatBudget chatBudget_ = ChatBudget::ofPlayers(1);
  ClientInputs inputs_;
  TickDelivery ticks_;
  ClientTransfers transfers_;
};

}  // namespace platon
