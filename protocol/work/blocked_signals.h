#pragma once

#include <signal.h>

namespace platon {

/// Blocks all signals of the calling thread as long as it lives. A thread that is started meanwhile keeps them blocked
/// for its whole life, so signals reach the main thread only, which they wake up.
class BlockedSignals {
 public:
  BlockedSignals();
  ~BlockedSignals();
  BlockedSignals(const BlockedSignals&) = delete;
  BlockedSignals& operator=(const BlockedSignals&) = delete;

 private:
  sigset_t before_;
};

}  // namespace platon
