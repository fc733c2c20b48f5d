#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "client/bot/bot.h"
#include "client/net/client_line.h"
#include "client/net/connection.h"
#include "client/session/hollow_session.h"

namespace platon {

/// A bot that does not play the game, for loading a server with players: hundreds of them fit on one machine. It does
/// not come back when it loses the connection.
class HollowBot : public Bot {
 public:
  /// As of PlayingBot.
  HollowBot(const ServerAddress& server, const std::string& name, const LinkQuality& line, std::uint64_t seed,
            Moment now, Moment settle);

  void update(Moment now) override;
  void leave() override;
  bool closed() const override { return connection_.state() == Connection::State::kClosed || ending().has_value(); }
  BotResult result() const override;

 private:
  std::optional<std::string> ending() const { return session_ ? session_->ending() : std::nullopt; }
  PredictionStatistics ticks() const;

  ClientLine line_;
  Connection connection_;
  std::string name_;
  std::optional<HollowSession> session_;  // once connected
  ButtonPresser presser_;
  HollowSession::Buttons buttons_;
  BotMeasure measure_;
  bool leaving_ = false;
};

}  // namespace platon
