#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace platon {

/// What the metrics of a server report. Counters count since its start.
struct Metrics {
  /// What has been rejected for one reason.
  struct Drop {
    std::string_view reason;  ///< in snake_case
    std::uint64_t count = 0;
  };

  std::string version;
  std::string serverName;
  std::uint64_t connectedPlayers = 0;
  std::uint64_t disconnectedPlayers = 0;
  std::uint64_t maxPlayers = 0;
  std::uint64_t bans = 0;
  std::uint64_t tickCount = 0;
  std::uint64_t tickSumUs = 0;  ///< of all ticks, microseconds
  std::uint64_t tickP50Us = 0;  ///< of the last minutes, as the next two
  std::uint64_t tickP99Us = 0;
  std::uint64_t tickMaxUs = 0;
  std::uint64_t receivedBytes = 0;  ///< payload of datagrams
  std::uint64_t sentBytes = 0;
  std::uint64_t missedInputs = 0;
  std::uint64_t desyncs = 0;
  std::vector<Drop> drops;
};

/// The metrics in the text format of Prometheus, version 0.0.4.
std::string formatMetrics(const Metrics& metrics);

}  // namespace platon
