#include "protocol/work/blocked_signals.h"

#include <gtest/gtest.h>

#include <thread>

namespace platon::blocked_signals_test {
namespace {

bool isBlocked(int signal) {
  sigset_t blocked;
  pthread_sigmask(SIG_SETMASK, nullptr, &blocked);
  return sigismember(&blocked, signal) == 1;
}

TEST(BlockedSignals, AThreadThatIsStartedMeanwhileKeepsThemBlocked) {
  bool hangup = false, interrupt = false, pipe = false;
  std::thread thread;
  {
    const BlockedSignals blocked;
    thread = std::thread([&] {
      hangup = isBlocked(SIGHUP);
      interrupt = isBlocked(SIGINT);
      pipe = isBlocked(SIGPIPE);
    });
  }
  thread.join();
  EXPECT_TRUE(hangup && interrupt && pipe);
}

TEST(BlockedSignals, TheCallerGetsItsOwnMaskBack) {
  ASSERT_FALSE(isBlocked(SIGHUP));
  {
    const BlockedSignals blocked;
    EXPECT_TRUE(isBlocked(SIGHUP));
  }
  EXPECT_FALSE(isBlocked(SIGHUP));
}

}  // namespace
}  // namespace platon::blocked_signals_test
