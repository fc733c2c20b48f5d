#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "server/net/time_point.h"

namespace platon {

/// Sends a request over HTTP to a program on this machine, on its loopback address of IPv4 or else of IPv6, and waits
/// for the status of the answer, for at most `limit`. Nothing if it is 200; otherwise what went wrong.
std::optional<std::string> sendOverLoopback(std::string request, std::uint16_t port, std::chrono::milliseconds limit,
                                            const std::function<TimePoint()>& clock);

}  // namespace platon
