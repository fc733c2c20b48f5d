#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "client/bot/bot.h"
#include "client/desync/desync_folder.h"
#include "client/net/network_conditions.h"
#include "client/net/server_address.h"
#include "client/time/clock.h"

namespace platon {

/// What a fleet of bots is told.
struct FleetOptions {
  int count = 1;  ///< 1 … 256
  double seconds = 10;
  std::uint64_t seed = 1;
  LinkQuality line;          ///< each way
  bool hollow = false;       ///< bots that do not play the game
  double settleSeconds = 0;  ///< from the first confirmed tick until a bot is measured
  std::string desyncFolder;  ///< for reports of games that were not the server's; empty: none are written
};

/// Bots that play together on one server.
class BotFleet {
 public:
  BotFleet(const FleetOptions& options, const ServerAddress& server, const Clock& clock)
      : options_(options), server_(server), clock_(clock), desyncs_(options.desyncFolder) {}

  /// Lets them come one after another, play until the time is over, and leave. Says on standard error when the game of
  /// one was not the server's. Throws std::runtime_error when one of them cannot even begin.
  std::vector<BotResult> play();

 private:
  void add(Moment now);
  std::unique_ptr<Bot> make(const std::string& name, std::uint64_t seed, Moment now) const;
  void beat(Moment now);
  void leave();

  FleetOptions options_;
  ServerAddress server_;
  Clock clock_;
  DesyncFolder desyncs_;
  std::vector<std::unique_ptr<Bot>> bots_;
};

}  // namespace platon
