#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "server/base/utc_time.h"

namespace platon {

/// What the metrics of a server report. Counters count since its start.
struct Metrics {
  /// What has been rejected for one reason.
  struct Drop {
    std::string_view reason;  ///< in snake_case
    std::uint64_t count = 0;
  };

  UtcTime startedAt;  ///< when the program started
  std::string version;
  std::string serverName;
  std::uint64_t connectedPlayers = 0;
  std::uint64_t disconnectedPlayers = 0;
  std::uint64_t maxPlayers = 0;
  std::uint64_t bans = 0;
  std::uint64_t tickCount = 0;
  std::uint64_t tickSumUs = 0;  ///< of all ticks, microseconds
  std::uint64_t tickP50Us = 0;  ///< of the last minutes, as the next two; 0 without ticks
  std::uint64_t tickP99Us = 0;
  std::uint64_t tickMaxUs = 0;
  std::uint64_t droppedTicks = 0;
  std::uint64_t receivedBytes = 0;  ///< payload of datagrams
  std::uint64_t sentBytes = 0;
  std::uint64_t missedInputs = 0;
  std::uint64_t desyncs = 0;
  std::vector<Drop> drops;
  std::uint64_t stoppedRecordings = 0;
  std::uint64_t unwrittenBans = 0;  ///< how often the file could not be written, as the next one
  std::uint64_t unwrittenBestTimes = 0;
};

/// The metrics in the text format of Prometheus, version 0.0.4.
std::string formatMetrics(const Metrics& metrics);

}  // namespace platon
