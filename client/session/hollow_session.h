#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "client/netcode/input_clock.h"
#include "client/netcode/link_meter.h"
#include "client/netcode/link_statistics.h"
#include "client/netcode/report_schedule.h"
#include "client/session/session.h"
#include "client/time/moment.h"
#include "protocol/assembly.h"
#include "protocol/to_client.h"
#include "protocol/to_server.h"

namespace platon {

/// A client's part in a match without the game: it greets, keeps the clock, presses buttons and confirms what it is
/// told with the hash that it is told, as if it had computed it. To the server it is a player like others, to the
/// machine it costs next to nothing, however many players there are. It never knows better than the server: nothing is
/// ever mispredicted or out of step. Levels of later rounds it does not fetch.
class HollowSession {
 public:
  /// The buttons of the next tick.
  using Buttons = std::function<Input()>;

  /// As of Session, but for good: without a token, there is no way back.
  HollowSession(const std::string& name, Moment now);
  void receive(std::span<const std::uint8_t> bytes, Moment now);
  void update(Moment now, const Buttons& buttons);
  void leave();
  std::vector<OutgoingMessage> takeOutgoing() { return std::exchange(outgoing_, {}); }
  /// Why it is over, a sentence.
  const std::optional<std::string>& ending() const { return ending_; }

  /// Over all rounds.
  std::uint32_t confirmedTicks() const { return pastTicks_ + heardTicks_; }
  LinkStatistics reading() const;

 private:
  /// How far it can say to be, and how it says so.
  struct Standing {
    std::uint32_t ticks = 0;
    std::uint8_t sync = 0;
  };

  template <class Message>
  void handle(const Message&, Moment) {}
  void handle(const Welcome& message, Moment now);
  void handle(const Refused& message, Moment now);
  void handle(const LevelChunk& message, Moment now);
  void handle(const StateChunk& message, Moment now);
  void handle(const RoundStart& message, Moment now);
  void handle(const Bye& message, Moment now);
  void handle(const ConfirmedTicks& message, Moment now);

  void choose(Moment now, const Buttons& buttons);
  PlayerInputs report();

  Moment helloAt_;
  std::optional<std::string> ending_;
  std::vector<OutgoingMessage> outgoing_;
  LinkMeter line_;
  Assembly levelText_;
  Assembly state_;
  bool ready_ = false;  // has the level, as a player would

  std::uint32_t round_ = 0;
  InputClock clock_{0};
  ReportSchedule schedule_;
  Standing standing_;
  std::optional<std::uint32_t> hash_;              // short, of the game there; none until the server has told one
  std::uint32_t next_ = 0;                         // tick of the next input
  std::array<Input, kMaxInputsPerMessage> own_{};  // by tick modulo their number
  std::uint32_t heardTicks_ = 0;                   // of the round
  std::uint32_t pastTicks_ = 0;                    // of the rounds before
};

}  // namespace platon
