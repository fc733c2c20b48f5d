#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "client/bot/bot.h"
#include "client/bot/button_presser.h"
#include "client/bot/server_route.h"
#include "client/net/connection.h"
#include "client/session/hollow_session.h"

namespace platon {

/// A bot without a game, for loading a server: hundreds run on one machine. It does not reconnect.
class HollowBot : public Bot {
 public:
  /// As for PlayingBot.
  HollowBot(const ServerAddress& server, const std::string& name, const ServerKnowledge& knowledge,
            const LinkQuality& quality, std::uint64_t seed, Moment now, Moment settle);

  void update(Moment now) override;
  void leave() override;
  bool closed() const override { return connection_.state() == Connection::State::kClosed || ending().has_value(); }
  BotResult result() const override;

 private:
  std::optional<std::string> ending() const { return session_ ? session_->ending() : std::nullopt; }
  PredictionStatistics prediction() const;

  ServerRoute route_;
  Connection connection_;
  std::string name_;
  std::optional<HollowSession> session_;  // empty until connected
  ButtonPresser presser_;
  HollowSession::Buttons buttons_;
  BotMeasure measure_;
  bool leaving_ = false;
};

}  // namespace platon
