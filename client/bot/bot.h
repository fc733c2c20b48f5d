#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "client/bot/button_presser.h"
#include "client/session/relayed_client.h"
#include "client/time/moment.h"

namespace platon {

/// What one bot went through. Rates, and the counts of the prediction but for its largest correction, are from the
/// first confirmed tick and its time to settle on, without joining; all else is from the start.
struct BotResult {
  bool joined = false;
  std::optional<std::string> ending;  ///< why it fell out, if it did
  double connectMs = 0;               ///< from the first datagram to the first confirmed tick
  LinkStatistics line;                ///< at the end
  std::uint32_t resumes = 0;          ///< how often it lost the connection and came back
  double seconds = 0;                 ///< of the rates; 0 when it did not come to that
  Traffic traffic;                    ///< in these seconds
  PredictionStatistics prediction;    ///< of a hollow bot: its ticks alone
  RoundStatistics round;              ///< of a hollow bot: nothing
};

/// A headless client that presses buttons.
class Bot {
 public:
  Bot() = default;
  virtual ~Bot() = default;
  Bot(const Bot&) = delete;
  Bot& operator=(const Bot&) = delete;

  /// To be called every few milliseconds.
  virtual void update(Moment now) = 0;
  virtual void leave() = 0;
  virtual std::optional<DesyncReport> takeDesync() { return std::nullopt; }
  virtual bool closed() const = 0;
  virtual BotResult result() const = 0;
};

/// From when on a bot is measured, and what there was before.
class BotMeasure {
 public:
  /// It begins to connect now, and counts from so long after its first confirmed tick on.
  BotMeasure(Moment now, Moment settle) : begunAt_(now), now_(now), settle_(settle) {}

  /// How far the bot is now.
  void update(Moment now, const PredictionStatistics& prediction, const Traffic& traffic);
  /// The part of a result that follows from this.
  BotResult result(const PredictionStatistics& prediction, const Traffic& traffic) const;

 private:
  Moment begunAt_;
  Moment now_;
  Moment settle_;
  std::optional<Moment> playingSince_;
  std::optional<Moment> countingSince_;
  PredictionStatistics predictionBefore_;
  Traffic trafficBefore_;
};

/// One that plays the game, on a line of its own.
class PlayingBot : public Bot {
 public:
  /// Begins to connect. Throws std::runtime_error when that cannot even begin.
  PlayingBot(const ServerAddress& server, const std::string& name, const LinkQuality& line, std::uint64_t seed,
             Moment now, Moment settle);

  void update(Moment now) override;
  void leave() override { client_->leave(); }
  std::optional<DesyncReport> takeDesync() override { return client_->takeDesync(); }
  bool closed() const override { return client_->closed() || client_->ending().has_value(); }
  BotResult result() const override;

 private:
  PredictionStatistics prediction() const;

  RelayedClient client_;
  ButtonPresser presser_;
  BotMeasure measure_;
};

}  // namespace platon
