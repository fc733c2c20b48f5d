#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "client/bot/bot.h"
#include "client/bot/button_presser.h"
#include "client/bot/server_route.h"
#include "client/session/network_client.h"

namespace platon {

/// A bot that plays the game.
class PlayingBot : public Bot {
 public:
  /// Starts to connect. `quality`: simulated network conditions each way. `seed`: of the buttons and the conditions.
  /// `settle`: time after the first confirmed tick before the bot is measured. Throws std::runtime_error if the host
  /// name cannot be resolved or no socket is available.
  PlayingBot(const ServerAddress& server, const std::string& name, const ServerKnowledge& knowledge,
             const LinkQuality& quality, std::uint64_t seed, Moment now, Moment settle);

  void update(Moment now) override;
  void leave() override { client_.leave(); }
  std::optional<DesyncReport> takeDesync() override { return client_.takeDesync(); }
  bool closed() const override { return client_.closed() || client_.ending().has_value(); }
  BotResult result() const override;

 private:
  PredictionStatistics prediction() const;

  ServerRoute route_;
  NetworkClient client_;
  ButtonPresser presser_;
  BotMeasure measure_;
};

}  // namespace platon
