#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "client/bot/bot_report.h"
#include "client/bot/button_presser.h"
#include "client/bot/hollow_session.h"
#include "client/desync/desync_report.h"
#include "client/net/enet_link.h"
#include "client/net/network_conditions.h"
#include "client/session/network_client.h"
#include "protocol/time.h"

namespace platon {

/// A headless client that presses buttons at random.
class Bot {
 public:
  Bot() = default;
  virtual ~Bot() = default;
  Bot(const Bot&) = delete;
  Bot& operator=(const Bot&) = delete;

  /// Call every few milliseconds.
  virtual void update(Time now) = 0;
  virtual void leave() = 0;
  virtual std::optional<DesyncReport> takeDesync() { return std::nullopt; }
  virtual bool closed() const = 0;
  virtual BotResult result() const = 0;
};

/// A bot that plays the game.
class PlayingBot : public Bot {
 public:
  /// Starts to connect. `quality`: simulated network conditions each way. `seed`: of the buttons and the conditions.
  /// `settle`: time after the first confirmed tick before the bot is measured. Throws std::runtime_error if the host
  /// name cannot be resolved or no socket is available.
  PlayingBot(const ServerAddress& server, const std::string& name, const ServerKnowledge& knowledge,
             const LinkQuality& quality, std::uint64_t seed, Time now, Time settle);

  void update(Time now) override;
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

/// A bot without a game, for loading a server: hundreds run on one machine. It does not reconnect.
class HollowBot : public Bot {
 public:
  /// As for PlayingBot.
  HollowBot(const ServerAddress& server, const std::string& name, const ServerKnowledge& knowledge,
            const LinkQuality& quality, std::uint64_t seed, Time now, Time settle);

  void update(Time now) override;
  void leave() override;
  bool closed() const override { return connection_.state() == EnetLink::State::kClosed || ending().has_value(); }
  BotResult result() const override;

 private:
  std::optional<SessionEnding> ending() const { return session_ ? session_->ending() : std::nullopt; }
  PredictionStatistics prediction() const;

  ServerRoute route_;
  EnetLink connection_;
  std::string name_;
  std::optional<HollowSession> session_;  // empty until connected
  ButtonPresser presser_;
  HollowSession::Buttons buttons_;
  BotMeasure measure_;
  bool leaving_ = false;
};

}  // namespace platon
