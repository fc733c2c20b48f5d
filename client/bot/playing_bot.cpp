#include "client/bot/playing_bot.h"

namespace platon {

PlayingBot::PlayingBot(const ServerAddress& server, const std::string& name, const ServerKnowledge& knowledge,
                       const LinkQuality& quality, std::uint64_t seed, Moment now, Moment settle)
    : route_(server, quality, seed),
      client_(server, {name, knowledge, route_.address()}, now),
      presser_(seed),
      measure_(now, settle) {}

void PlayingBot::update(Moment now) {
  route_.pump(now);
  client_.update(now, [this](const Game&, std::uint32_t) { return presser_.next(); });
  route_.pump(now);
  measure_.update(now, prediction(), client_.traffic());
}

PredictionStatistics PlayingBot::prediction() const {
  return client_.session() ? client_.session()->predictionStatistics() : PredictionStatistics();
}

BotResult PlayingBot::result() const {
  BotResult result = measure_.result(prediction(), client_.traffic());
  result.ending = client_.ending() ? client_.ending() : client_.outage();
  if (!result.joined) return result;
  result.link = client_.session()->linkStatistics();
  result.resumes = client_.resumes();
  result.round = client_.session()->roundStatistics();
  return result;
}

}  // namespace platon
