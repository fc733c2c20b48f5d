#pragma once

#include <atomic>

#include "client/job/job.h"
#include "tests/support/wait_until.h"

namespace platon {

/// Starts threads that do not begin their work while they are held, unless they are asked to stop.
class HeldThreads {
 public:
  void hold() { held_ = true; }
  void letGo() { held_ = false; }
  /// This object outlives the threads.
  ThreadStart start() {
    return [this](std::function<void(const std::stop_token&)> work) {
      return startThread([this, work = std::move(work)](const std::stop_token& stop) {
        waitUntil([&] { return !held_ || stop.stop_requested(); });
        work(stop);
      });
    };
  }

 private:
  std::atomic<bool> held_ = false;
};

}  // namespace platon
