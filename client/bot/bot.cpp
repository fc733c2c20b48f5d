#include "client/bot/bot.h"

#include <span>

#include "protocol/transport/udp_socket.h"

namespace platon {

PlayingBot::PlayingBot(const ServerAddress& server, const std::string& name, const ServerKnowledge& knowledge,
                       const LinkQuality& quality, std::uint64_t seed, Time now, Time settle)
    : route_(server, quality, seed),
      client_(enetLinks(server, route_.address()), {name, knowledge}, now),
      presser_(seed),
      measure_(now, settle) {}

void PlayingBot::update(Time now) {
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

HollowBot::HollowBot(const ServerAddress& server, const std::string& name, const ServerKnowledge& knowledge,
                     const LinkQuality& quality, std::uint64_t seed, Time now, Time settle)
    : route_(server, quality, seed),
      connection_(resolve(route_.address().host, route_.address().port), knowledge),
      name_(name),
      presser_(seed),
      buttons_([this] { return presser_.next(); }),
      measure_(now, settle) {}

void HollowBot::update(Time now) {
  route_.pump(now);
  connection_.service(now, [this, now](std::span<const std::uint8_t> message) {
    if (session_) session_->receive(message, now);
  });
  if (!session_ && connection_.state() == EnetLink::State::kConnected) session_.emplace(name_, now);
  if (session_ && !leaving_) session_->update(now, buttons_);
  if (session_) {
    for (const OutgoingMessage& message : session_->takeOutgoing()) connection_.send(message.bytes, message.reliable);
  }
  if (leaving_) connection_.close();
  connection_.flush(now);
  route_.pump(now);
  measure_.update(now, prediction(), connection_.traffic());
}

void HollowBot::leave() {
  leaving_ = true;
  if (session_) session_->leave();
}

PredictionStatistics HollowBot::prediction() const {
  PredictionStatistics statistics;
  if (session_) statistics.confirmedTicks = session_->confirmedTicks();
  return statistics;
}

BotResult HollowBot::result() const {
  BotResult result = measure_.result(prediction(), connection_.traffic());
  if (ending()) result.ending = ending()->reason;
  if (!result.ending && closed()) result.ending = "lost the connection";
  if (result.joined) result.link = session_->linkStatistics();
  return result;
}

}  // namespace platon
