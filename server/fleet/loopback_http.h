#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "server/net/time_point.h"

namespace platon {

/// How much of an answer is waited for.
enum class LoopbackPart : std::uint8_t { kStatus, kBody };

/// What a program on this machine has answered.
struct LoopbackAnswer {
  std::optional<std::string> fault;  ///< what went wrong; nothing if the status is 200
  std::string body{};                ///< if it was waited for: what follows the head, until the connection was closed
};

/// Sends a request over HTTP to a program on this machine, on its loopback address of IPv4 or else of IPv6, and waits
/// for this part of the answer, for at most `limit`. An answer has at most 1 MiB.
LoopbackAnswer sendOverLoopback(std::string request, std::uint16_t port, LoopbackPart part,
                                std::chrono::milliseconds limit, const std::function<TimePoint()>& clock);

}  // namespace platon
