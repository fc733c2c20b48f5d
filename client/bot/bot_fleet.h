#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "client/bot/bot.h"
#include "client/desync/desync_report.h"
#include "client/net/network_conditions.h"
#include "client/time/clock.h"
#include "protocol/program_options.h"
#include "protocol/transport/client_gate.h"
#include "protocol/transport/server_address.h"

namespace platon {

/// Adds the options for simulated network conditions, in a group of their own: --loss --burst-loss --burst-length
/// --delay --jitter --duplicate --reorder --rate --corrupt. Reading writes the values to `quality`, and refuses values
/// out of range and --burst-length without --burst-loss.
void addConditionOptions(ProgramOptions& program, LinkQuality& quality);

struct FleetOptions {
  int count = 1;  ///< 1 … 256
  double seconds = 10;
  std::uint64_t seed = 1;
  LinkQuality quality;          ///< simulated network conditions, each way
  bool hollow = false;          ///< HollowBot instead of PlayingBot
  double settleSeconds = 0;     ///< time from a bot's first confirmed tick until it is measured
  ServerKnowledge knowledge{};  ///< what every bot knows of the server
  std::string desyncFolder;     ///< for desync reports; empty: none are written
};

/// Bots that play together on one server.
class BotFleet {
 public:
  BotFleet(const FleetOptions& options, const ServerAddress& server, const Clock& clock)
      : options_(options), server_(server), clock_(clock), desyncFolder_(options.desyncFolder) {}

  /// Lets the bots join one after another, play for the given time, and leave. Logs desyncs on standard error. Throws
  /// std::runtime_error if the host name cannot be resolved or no socket is available.
  std::vector<BotResult> play();

 private:
  void add(Time now);
  std::unique_ptr<Bot> make(const std::string& name, std::uint64_t seed, Time now) const;
  void update(Time now);
  void leave();

  FleetOptions options_;
  ServerAddress server_;
  Clock clock_;
  DesyncFolder desyncFolder_;
  std::vector<std::unique_ptr<Bot>> bots_;
};

}  // namespace platon
