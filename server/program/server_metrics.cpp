#include "server/program/server_metrics.h"

#include <algorithm>

#include "platon_version.h"

namespace platon {
namespace {

using Samples = std::vector<MetricSample>;

Samples one(std::uint64_t value) { return {{std::to_string(value), {}, {}}}; }

Samples players(const DedicatedServer& server) {
  const std::vector<PlayerStatus> all = server.match().playerStatus();
  const auto connected = std::count_if(all.begin(), all.end(), [](const auto& player) { return player.client; });
  const auto disconnected = static_cast<std::ptrdiff_t>(all.size()) - connected;
  return {{std::to_string(connected), {{"state", "connected"}}, {}},
          {std::to_string(disconnected), {{"state", "disconnected"}}, {}}};
}

Samples tickTimes(const TickTimes& all, const TickTimes& recent) {
  return {{secondsText(recent.quantile(0.5)), {{"quantile", "0.5"}}, {}},
          {secondsText(recent.quantile(0.99)), {{"quantile", "0.99"}}, {}},
          {secondsText(all.sum()), {}, "_sum"},
          {std::to_string(all.count()), {}, "_count"}};
}

Samples drops(const DedicatedServer& server) {
  Samples samples;
  for (const Rejection& each : server.host().rejections().list())
    samples.push_back({std::to_string(each.count), {{"reason", std::string(each.reason)}}, {}});
  return samples;
}

}  // namespace

std::vector<Metric> metricsOf(const DedicatedServer& server, const ProgramFacts& facts) {
  const TickTimes recent = server.recentTickTimes();
  const auto& traffic = server.host().gate().traffic();
  return {
      {"process_start_time_seconds", "gauge", "Start of the program, in seconds since 1970 (UTC).",
       one(static_cast<std::uint64_t>(facts.startedAt.time_since_epoch().count()))},
      {"platon_info",
       "gauge",
       "Version and name of the server; always 1.",
       {{"1", {{"version", std::string(kVersion)}, {"name", facts.serverName}}, {}}}},
      {"platon_players", "gauge", "Players; disconnected ones are kept for a minute.", players(server)},
      {"platon_players_limit", "gauge", "Largest number of players.", one(facts.maxPlayers)},
      {"platon_bans", "gauge", "Bans in the list.", one(facts.bans)},
      {"platon_tick_seconds", "summary",
       "Time that a tick takes. The quantiles are of the last one to two minutes, 0 without ticks.",
       tickTimes(server.tickTimes(), recent)},
      {"platon_tick_max_seconds",
       "gauge",
       "Longest tick of the last one to two minutes, 0 without ticks.",
       {{secondsText(recent.longest()), {}, {}}}},
      {"platon_dropped_ticks_total", "counter", "Ticks that were dropped because the server was paused or too slow.",
       one(server.droppedTicks())},
      {"platon_received_bytes_total", "counter", "Bytes of received datagrams.", one(traffic.receivedBytes)},
      {"platon_sent_bytes_total", "counter", "Bytes of sent datagrams.", one(traffic.sentBytes)},
      {"platon_missed_inputs_total", "counter",
       "Inputs that came too late, and differed from what the server had decided.", one(server.match().missedInputs())},
      {"platon_desyncs_total", "counter", "Games of clients that differed from the server's.", one(server.desyncs())},
      {"platon_drops_total", "counter", "Traffic that was rejected, by reason.", drops(server)},
      {"platon_stopped_recordings_total", "counter", "Recordings that could not be written to their end.",
       one(server.stoppedRecordings())},
      {"platon_unwritten_bans_total", "counter",
       "How often the ban file could not be written; the server tries again every 10 s.", one(facts.unwrittenBans)},
      {"platon_unwritten_best_times_total", "counter",
       "How often the file of the best times could not be written; the server tries again every 10 s.",
       one(server.unwrittenBestTimes())},
  };
}

}  // namespace platon
