#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "client/time/clock.h"
#include "client/time/steady_now.h"
#include "protocol/transport/server_address.h"
#include "server/app/dedicated_server.h"
#include "tests/support/test_levels.h"

namespace platon {

/// A server on a loopback socket, and a virtual clock. Sleeping on the clock steps the server once and advances the
/// time, so that server and clients run in one thread.
class LoopbackServer {
 public:
  LoopbackServer() : LoopbackServer([](std::string_view) {}) {}
  /// `sink` receives the lines of the log. An empty password: none.
  explicit LoopbackServer(std::function<void(std::string_view)> sink, const std::string& password = "",
                          const std::shared_ptr<const Level>& level = endlessLevel())
      : server_(settings(password), {level}, Log(LogFormat::kText, std::move(sink))) {}

  ServerAddress address() const { return {kLoopback, server_.port()}; }
  DedicatedServer& server() { return server_; }
  const Clock& clock() const { return clock_; }

  /// Calls `update(now)` every 2 ms until `done()` returns true, for at most `timeout` of virtual time. Returns whether
  /// it is done.
  template <class Update, class Done>
  bool runUntil(Time timeout, Update update, Done done) {
    const Time end = now_ + timeout;
    while (now_ < end) {
      update(now_);
      if (done()) return true;
      clock_.sleepUntil(now_ + std::chrono::milliseconds(2));
    }
    return false;
  }

  /// Calls `update(now)` every 2 ms for `duration` of virtual time while the server is suspended.
  template <class Update>
  void suspend(Time duration, Update update) {
    for (const Time end = now_ + duration; now_ < end; now_ += std::chrono::milliseconds(2)) update(now_);
  }

 private:
  static constexpr const char* kLoopback = "127.0.0.1";

  static ServerSettings settings(const std::string& password) {
    ServerSettings settings;
    settings.password = password;
    settings.bind = kLoopback;
    return settings;
  }

  DedicatedServer server_;
  Time now_ = steadyClock().now();
  Clock clock_{[this] { return now_; },
               [this](Time until) {
                 server_.step(TimePoint(now_));
                 now_ = until;
               }};
};

}  // namespace platon
