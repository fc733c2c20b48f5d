#include "client/bot/bot.h"

namespace platon {

void BotMeasure::update(Moment now, const PredictionStatistics& prediction, const Traffic& traffic) {
  now_ = now;
  if (!playingSince_ && prediction.confirmedTicks > 0) playingSince_ = now;
  if (!playingSince_ || countingSince_ || now - *playingSince_ < settle_) return;
  countingSince_ = now;
  if (settle_ > Moment{}) predictionBefore_ = prediction;
  trafficBefore_ = traffic;
}

BotResult BotMeasure::result(const PredictionStatistics& prediction, const Traffic& traffic) const {
  BotResult result;
  result.joined = playingSince_.has_value();
  if (!result.joined) return result;
  result.connectMs = toSeconds(*playingSince_ - begunAt_) * 1000;
  if (!countingSince_) return result;
  result.seconds = toSeconds(now_ - *countingSince_);
  result.traffic = traffic - trafficBefore_;
  result.prediction = prediction - predictionBefore_;
  return result;
}

PlayingBot::PlayingBot(const ServerAddress& server, const std::string& name, const LinkQuality& line,
                       std::uint64_t seed, Moment now, Moment settle)
    : client_(server, name, line, seed, now), presser_(seed), measure_(now, settle) {}

void PlayingBot::update(Moment now) {
  client_.update(now, [this](const Game&, std::uint32_t) { return presser_.next(); });
  measure_.update(now, prediction(), client_->traffic());
}

PredictionStatistics PlayingBot::prediction() const {
  return client_->session() ? client_->session()->predictionStatistics() : PredictionStatistics();
}

BotResult PlayingBot::result() const {
  BotResult result = measure_.result(prediction(), client_->traffic());
  result.ending = client_->ending() ? client_->ending() : client_->outage();
  if (!result.joined) return result;
  result.line = client_->session()->reading();
  result.resumes = client_->resumes();
  result.round = client_->session()->roundStatistics();
  return result;
}

}  // namespace platon
