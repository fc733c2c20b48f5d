#include "server/app/server_metrics.h"

#include "platon_version.h"

namespace platon {
namespace {

std::vector<Metrics::Drop> dropsOf(const DedicatedServer& server) {
  std::vector<Metrics::Drop> drops;
  for (const Rejection& each : server.rejections()) drops.push_back({each.reason, each.count});
  return drops;
}

}  // namespace

Metrics metricsOf(const DedicatedServer& server) {
  Metrics metrics;
  metrics.version = kVersion;
  for (const PlayerStatus& player : server.match().playerStatus()) {
    ++(player.client ? metrics.connectedPlayers : metrics.disconnectedPlayers);
  }
  const TickTimes recent = server.recentTickTimes();
  metrics.tickCount = server.tickTimes().count();
  metrics.tickSumUs = server.tickTimes().sum();
  metrics.tickP50Us = recent.quantile(0.5);
  metrics.tickP99Us = recent.quantile(0.99);
  metrics.tickMaxUs = recent.longest();
  metrics.droppedTicks = server.droppedTicks();
  metrics.missedInputs = server.match().missedInputs();
  metrics.desyncs = server.desyncs();
  metrics.receivedBytes = server.host().gate().traffic().receivedBytes;
  metrics.sentBytes = server.host().gate().traffic().sentBytes;
  metrics.drops = dropsOf(server);
  metrics.stoppedRecordings = server.stoppedRecordings();
  metrics.unwrittenBestTimes = server.unwrittenBestTimes();
  return metrics;
}

}  // namespace platon
