#include "client/bot/bot_measure.h"

namespace platon {

void BotMeasure::update(Moment now, const PredictionStatistics& prediction, const Traffic& traffic) {
  now_ = now;
  if (!playingSince_ && prediction.confirmedTicks > 0) playingSince_ = now;
  if (!playingSince_ || measuredSince_ || now - *playingSince_ < settle_) return;
  measuredSince_ = now;
  if (settle_ > Moment{}) predictionBefore_ = prediction;
  trafficBefore_ = traffic;
}

BotResult BotMeasure::result(const PredictionStatistics& prediction, const Traffic& traffic) const {
  BotResult result;
  result.joined = playingSince_.has_value();
  if (!result.joined) return result;
  result.connectMs = toSeconds(*playingSince_ - startedAt_) * 1000;
  if (!measuredSince_) return result;
  result.seconds = toSeconds(now_ - *measuredSince_);
  result.traffic = traffic - trafficBefore_;
  result.prediction = prediction - predictionBefore_;
  return result;
}

}  // namespace platon
