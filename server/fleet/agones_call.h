#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "server/base/time_point.h"

namespace platon {

/// Environment variable with the TCP port of the sidecar, which Agones sets.
inline constexpr const char* kAgonesPortVariable = "AGONES_SDK_HTTP_PORT";

/// The port in a value of this variable; null or empty: none. Throws ProgramError (kUsage) if it is no port.
std::optional<std::uint16_t> agonesPortOf(const char* value);

/// What the server tells Agones, or asks it, through the process that Agones runs beside it, its sidecar.
enum class AgonesCall : std::uint8_t {
  kReady,       ///< players can be sent to the server; it may be removed
  kHealth,      ///< the server is alive
  kAllocate,    ///< somebody plays: the server must not be removed
  kPlayers,     ///< number of players
  kGameServer,  ///< when was the server allocated?
  kShutdown,    ///< the server has stopped
};
inline constexpr std::size_t kAgonesCalls = 6;

/// One word, for the log.
std::string_view nameOf(AgonesCall call);

/// How many players the server has, and how many it can have.
struct PlayerCount {
  std::uint32_t players = 0;
  std::uint32_t limit = 0;

  friend bool operator==(const PlayerCount&, const PlayerCount&) = default;
};

/// What a call has brought.
struct AgonesAnswer {
  std::optional<std::string> fault;  ///< what went wrong; nothing if the call succeeded
  std::string allocation{};          ///< of kGameServer: what lastAllocation() reads
};

/// The request of HTTP that makes the call, for a sidecar on this port of the loopback interface. Paths and bodies are
/// those of sdks/swagger/sdk.swagger.json and beta.swagger.json of github.com/googleforgames/agones. `count` is sent by
/// kPlayers alone.
std::string agonesRequest(AgonesCall call, std::uint16_t port, const PlayerCount& count);

/// The annotation agones.dev/last-allocated of the game server that a body of an answer to kGameServer describes, a
/// time that differs for each allocation; empty if the server was never allocated. Nothing if the body describes none.
std::optional<std::string> lastAllocation(std::string_view body);

/// The status of a response of HTTP/1.0 or HTTP/1.1, 100 … 999, once its first line has arrived. 0: the line is none.
/// Nothing: the line is incomplete.
std::optional<int> statusOf(std::string_view received);

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
