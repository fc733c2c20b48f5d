#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "client/netcode/clock_sync.h"
#include "client/time/moment.h"
#include "protocol/to_client.h"

namespace platon {

/// The clock of one round: for which ticks a client has to have chosen its inputs by now. Runs from the first message
/// of ticks on that tells how far the server is.
class InputClock {
 public:
  /// `lead`: ticks that a client must be ahead of the newest tick it hears of, as far as is known.
  explicit InputClock(double lead) : lead_(lead) {}

  /// The lead to begin with when this is the time from Hello to Welcome.
  static double firstLead(Moment greeting);

  /// A message of the round, news or not.
  void receive(const ConfirmedTicks& message, Moment now);

  /// Lets time pass; the next input to be chosen is that for `next`, all up to the time are chosen together.
  void update(Moment now, std::uint32_t next);
  /// Whether to have chosen the input for this tick by now.
  bool reaches(std::uint32_t tick) const { return sync_ && tick + 1 <= sync_->tick(); }
  /// The input for this tick is chosen.
  void chose(std::uint32_t tick);

  /// The own player is absent before this tick, by the client's own doing.
  std::uint32_t firstInput() const { return firstInput_; }
  /// None until it runs.
  const std::optional<ClockSync>& sync() const { return sync_; }
  /// Ticks ahead of the newest tick heard of; what was given until it runs.
  double lead() const { return lead_; }
  /// By how many ticks an own input last came before the server needed it; 0 before the first report.
  std::int32_t slack() const { return slack_; }

 private:
  static constexpr std::size_t kMaxTogether = 256;

  void set(std::uint32_t newest, Moment now);
  void judge(const SlackReport& report);

  std::optional<ClockSync> sync_;
  double lead_;
  std::uint32_t firstInput_ = 0;
  std::uint32_t next_ = 0;                           // at the last update
  std::array<std::uint32_t, kMaxTogether> burst_{};  // by tick modulo kMaxTogether: ticks before it that were
                                                     // chosen together with it
  bool hiccup_ = false;                              // the last update came long after the one before
  std::int32_t slack_ = 0;
};

}  // namespace platon
