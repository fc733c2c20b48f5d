#pragma once

#include <string>

#include "server/admin/metrics_text.h"
#include "server/app/dedicated_server.h"

namespace platon {

/// The metrics of a server, without those that it does not know: when it started, its name, the limit of players, and
/// what concerns the bans.
Metrics metricsOf(const DedicatedServer& server);

}  // namespace platon
