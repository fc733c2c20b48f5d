#pragma once

#include <functional>

#include "client/time/clock.h"
#include "protocol/moment.h"

namespace platon {

/// Calls `update` every 2 ms until `closed` returns true, for half a second at most: the time that a Leave message gets
/// to reach the server.
void updateUntilClosed(const Clock& clock, const std::function<void(Moment)>& update,
                       const std::function<bool()>& closed);

}  // namespace platon
