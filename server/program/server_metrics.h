#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "server/admin/metrics.h"
#include "server/app/dedicated_server.h"
#include "server/base/utc_time.h"

namespace platon {

/// What a server does not know about its program. Without defaults, so that who lists them and forgets one is warned.
struct ProgramFacts {
  UtcTime startedAt;
  std::string serverName;
  std::uint64_t maxPlayers;
  std::uint64_t bans;
  std::uint64_t unwrittenBans;  ///< how often the file could not be written
};

/// All metrics: one row each. A row is described in docs/hosting.md, too, shown by the dashboard in deploy/monitoring,
/// and watched by an alert there or by none on purpose. server_metrics_test and the test `deploy_monitoring` name those
/// that lack.
std::vector<Metric> metricsOf(const DedicatedServer& server, const ProgramFacts& facts);

}  // namespace platon
