#include "client/session/farewell.h"

#include <chrono>

namespace platon {

namespace {

constexpr Moment kUpdateInterval = std::chrono::milliseconds(2);
constexpr Moment kTimeout = std::chrono::milliseconds(500);

}  // namespace

void updateUntilClosed(const Clock& clock, const std::function<void(Moment)>& update,
                       const std::function<bool()>& closed) {
  const Moment end = clock.now() + kTimeout;
  for (Moment now = clock.now(); now < end && !closed(); now = clock.now()) {
    update(now);
    clock.sleepUntil(now + kUpdateInterval);
  }
}

}  // namespace platon
