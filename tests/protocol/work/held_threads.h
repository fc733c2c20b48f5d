#pragma once

#include <atomic>
#include <functional>
#include <utility>

#include "protocol/work/worker.h"
#include "tests/support/wait_until.h"

namespace platon {

/// Starts threads that do not begin their work while they are held.
class HeldThreads {
 public:
  void hold() { held_ = true; }
  void letGo() { held_ = false; }
  /// This object outlives the threads.
  ThreadStart start() {
    return [this](std::function<void()> run) {
      return startThread([this, run = std::move(run)] {
        waitUntil([&] { return !held_; });
        run();
      });
    };
  }

 private:
  std::atomic<bool> held_ = false;
};

}  // namespace platon
