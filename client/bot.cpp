#include "client/bot.h"

namespace platon {

Bot::Bot(const ServerAddress& server, const std::string& name, const LinkQuality& line, std::uint64_t seed, Moment now)
    : client_(server, name, line, seed, now), presser_(seed), begunAt_(now), now_(now) {}

void Bot::update(Moment now) {
  now_ = now;
  client_.update(now, [this](const Game&, std::uint32_t) { return presser_.next(); });
  if (!playingSince_) noteStart(now);
}

void Bot::noteStart(Moment now) {
  const Session* const session = client_->session();
  if (session == nullptr || session->predictionCount().confirmedTicks == 0) return;
  playingSince_ = now;
  trafficBefore_ = client_->traffic();
}

BotResult Bot::result() const {
  BotResult result;
  result.joined = playingSince_.has_value();
  result.ending = client_->ending() ? client_->ending() : client_->outage();
  if (!result.joined) return result;
  result.connectMs = toSeconds(*playingSince_ - begunAt_) * 1000;
  result.line = client_->session()->reading();
  result.returns = client_->returns();
  result.seconds = toSeconds(now_ - *playingSince_);
  result.traffic = client_->traffic() - trafficBefore_;
  result.prediction = client_->session()->predictionCount();
  result.round = client_->session()->roundCount();
  return result;
}

}  // namespace platon
