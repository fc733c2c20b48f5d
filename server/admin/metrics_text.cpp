#include "server/admin/metrics_text.h"

#include <array>
#include <cstdio>
#include <initializer_list>
#include <utility>

namespace platon {
namespace {

using Label = std::pair<std::string_view, std::string_view>;

std::string escaped(std::string_view text) {
  std::string result;
  for (const char byte : text) {
    if (byte == '\\' || byte == '"') result += '\\';
    if (byte == '\n')
      result += "\\n";
    else
      result += byte;
  }
  return result;
}

// Exact: a whole number of microseconds.
std::string secondsOf(std::uint64_t microseconds) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%llu.%06llu", static_cast<unsigned long long>(microseconds / 1'000'000),
                static_cast<unsigned long long>(microseconds % 1'000'000));
  return text.data();
}

/// Writes one metric after the other, each with its description, type and samples.
class Writer {
 public:
  void begin(std::string_view name, std::string_view type, std::string_view help) {
    text_.append("# HELP ").append(name).append(" ").append(help).append("\n");
    text_.append("# TYPE ").append(name).append(" ").append(type).append("\n");
  }

  void sample(std::string_view name, std::initializer_list<Label> labels, const std::string& value) {
    text_ += name;
    char separator = '{';
    for (const auto& [label, content] : labels) {
      text_.append(1, separator).append(label).append("=\"").append(escaped(content)).append("\"");
      separator = ',';
    }
    text_.append(labels.size() > 0 ? "} " : " ").append(value).append("\n");
  }

  void single(std::string_view name, std::string_view type, std::string_view help, std::uint64_t value) {
    begin(name, type, help);
    sample(name, {}, std::to_string(value));
  }

  std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

void writeStart(Writer& writer, const Metrics& metrics) {
  writer.begin("process_start_time_seconds", "gauge", "Start of the program, in seconds since 1970 (UTC).");
  writer.sample("process_start_time_seconds", {}, std::to_string(metrics.startedAt.time_since_epoch().count()));
}

void writePlayers(Writer& writer, const Metrics& metrics) {
  writer.begin("platon_info", "gauge", "Version and name of the server; always 1.");
  writer.sample("platon_info", {{"version", metrics.version}, {"name", metrics.serverName}}, "1");
  writer.begin("platon_players", "gauge", "Players; disconnected ones are kept for a minute.");
  writer.sample("platon_players", {{"state", "connected"}}, std::to_string(metrics.connectedPlayers));
  writer.sample("platon_players", {{"state", "disconnected"}}, std::to_string(metrics.disconnectedPlayers));
  writer.single("platon_players_limit", "gauge", "Largest number of players.", metrics.maxPlayers);
  writer.single("platon_bans", "gauge", "Bans in the list.", metrics.bans);
}

void writeTicks(Writer& writer, const Metrics& metrics) {
  writer.begin("platon_tick_seconds", "summary",
               "Time that a tick takes. The quantiles are of the last one to two minutes, 0 without ticks.");
  writer.sample("platon_tick_seconds", {{"quantile", "0.5"}}, secondsOf(metrics.tickP50Us));
  writer.sample("platon_tick_seconds", {{"quantile", "0.99"}}, secondsOf(metrics.tickP99Us));
  writer.sample("platon_tick_seconds_sum", {}, secondsOf(metrics.tickSumUs));
  writer.sample("platon_tick_seconds_count", {}, std::to_string(metrics.tickCount));
  writer.begin("platon_tick_max_seconds", "gauge", "Longest tick of the last one to two minutes, 0 without ticks.");
  writer.sample("platon_tick_max_seconds", {}, secondsOf(metrics.tickMaxUs));
  writer.single("platon_dropped_ticks_total", "counter",
                "Ticks that were dropped because the server was stopped or too slow.", metrics.droppedTicks);
}

void writeTraffic(Writer& writer, const Metrics& metrics) {
  writer.single("platon_received_bytes_total", "counter", "Bytes of received datagrams.", metrics.receivedBytes);
  writer.single("platon_sent_bytes_total", "counter", "Bytes of sent datagrams.", metrics.sentBytes);
  writer.single("platon_missed_inputs_total", "counter",
                "Ticks of connected players that were decided without their input.", metrics.missedInputs);
  writer.single("platon_desyncs_total", "counter", "Games of clients that differed from the server's.",
                metrics.desyncs);
  writer.begin("platon_drops_total", "counter", "Traffic that was rejected, by reason.");
  for (const Metrics::Drop& drop : metrics.drops) {
    writer.sample("platon_drops_total", {{"reason", drop.reason}}, std::to_string(drop.count));
  }
}

void writeFiles(Writer& writer, const Metrics& metrics) {
  writer.single("platon_stopped_recordings_total", "counter", "Recordings that could not be written to their end.",
                metrics.stoppedRecordings);
  writer.single("platon_unwritten_bans_total", "counter",
                "How often the ban file could not be written; it is tried every 10 s.", metrics.unwrittenBans);
  writer.single("platon_unwritten_best_times_total", "counter",
                "How often the file of the best times could not be written; it is tried every 10 s.",
                metrics.unwrittenBestTimes);
}

}  // namespace

std::string formatMetrics(const Metrics& metrics) {
  Writer writer;
  writeStart(writer, metrics);
  writePlayers(writer, metrics);
  writeTicks(writer, metrics);
  writeTraffic(writer, metrics);
  writeFiles(writer, metrics);
  return writer.take();
}

}  // namespace platon
