#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "client/button_presser.h"
#include "client/moment.h"
#include "client/relayed_client.h"

namespace platon {

/// What one bot went through. Rates count from the first confirmed tick on, without joining.
struct BotResult {
  bool joined = false;
  std::optional<std::string> ending;     ///< why it fell out, if it did
  double connectMs = 0;                  ///< from the first datagram to the first confirmed tick
  LineReading line;                      ///< at the end
  std::uint32_t returns = 0;             ///< how often it lost the connection and came back
  double seconds = 0;                    ///< from the first confirmed tick on
  Traffic traffic;                       ///< in these seconds
  PredictionCount prediction;
  RoundCount round;
};

/// A headless client that presses buttons at random, on a line of its own.
class Bot {
 public:
  /// Begins to connect. Throws std::runtime_error when that cannot even begin.
  Bot(const ServerAddress& server, const std::string& name, const LinkQuality& line, std::uint64_t seed, Moment now);

  /// To be called every few milliseconds.
  void update(Moment now);
  void leave() { client_->leave(); }
  std::optional<MismatchReport> takeMismatch() { return client_->takeMismatch(); }
  bool closed() const { return client_->closed() || client_->ending().has_value(); }

  BotResult result() const;

 private:
  void noteStart(Moment now);

  RelayedClient client_;
  ButtonPresser presser_;
  Moment begunAt_;
  std::optional<Moment> playingSince_;
  Traffic trafficBefore_;
  Moment now_;
};

}  // namespace platon
