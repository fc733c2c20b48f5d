#pragma once

#include <chrono>
#include <string>
#include <string_view>

#include "protocol/files/descriptor.h"
#include "server/base/time_point.h"

namespace platon {

/// Tells the program that has started the server, such as systemd, how it is: the protocol of sd_notify(3). Whoever
/// calls it does so from the loop that runs the ticks, so that a stalled loop says nothing and is restarted. A message
/// that does not arrive is lost: it must neither hold up nor end a server.
class ServiceManager {
 public:
  /// Where and how often, as the environment names it: NOTIFY_SOCKET and WATCHDOG_USEC; null: not given. With
  /// WATCHDOG_PID, which must then be `process`, or else no watchdog waits for this server.
  struct Environment {
    const char* socket = nullptr;
    const char* watchdogMicroseconds = nullptr;
    const char* watchdogProcess = nullptr;
    long process = 0;

    /// That of this process.
    static Environment current();
  };

  /// `socket` is an absolute path, or a name in the abstract namespace that begins with '@'. Any other and an empty one
  /// tell nobody.
  explicit ServiceManager(const Environment& environment);

  /// The server serves, or serves again after `reloading`.
  void ready();
  /// It reads its configuration again, since `now`, a time of the steady clock; `ready` ends that.
  void reloading(TimePoint now);
  void stopping();
  /// The loop goes round. Call it in each step: it tells so twice in each period of the watchdog.
  /// While it drains, it also asks for another kStopTime each time, so that a stop may take as long as the drain.
  void alive(TimePoint now, bool draining);

  /// Longer than what a server may do between the last sign of life and its end.
  static constexpr std::chrono::seconds kStopTime{60};

  /// Whether a watchdog waits for `alive`.
  bool watched() const { return interval_.count() > 0; }

 private:
  void tell(std::string_view message) const;

  std::string address_;  // as in sockaddr_un; empty: nobody is told
  Descriptor socket_;
  std::chrono::microseconds interval_{};  // between two signs of life; 0: no watchdog
  TimePoint nextSign_{};
};

}  // namespace platon
