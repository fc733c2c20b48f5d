#include "client/bot/hollow_bot.h"

#include <span>

namespace platon {

HollowBot::HollowBot(const ServerAddress& server, const std::string& name, const LinkQuality& line, std::uint64_t seed,
                     Moment now, Moment settle)
    : line_(server, line, seed),
      connection_(line_.address(), now),
      name_(name),
      presser_(seed),
      buttons_([this] { return presser_.next(); }),
      measure_(now, settle) {}

void HollowBot::update(Moment now) {
  line_.pump(now);
  connection_.service(now, [this, now](std::span<const std::uint8_t> message) {
    if (session_) session_->receive(message, now);
  });
  if (!session_ && connection_.state() == Connection::State::kConnected) session_.emplace(name_, now);
  if (session_ && !leaving_) session_->update(now, buttons_);
  if (session_) {
    for (const OutgoingMessage& message : session_->takeOutgoing()) connection_.send(message.bytes, message.reliable);
  }
  if (leaving_) connection_.close();
  connection_.flush(now);
  line_.pump(now);
  measure_.update(now, ticks(), connection_.traffic());
}

void HollowBot::leave() {
  leaving_ = true;
  if (session_) session_->leave();
}

PredictionStatistics HollowBot::ticks() const {
  PredictionStatistics count;
  if (session_) count.confirmedTicks = session_->confirmedTicks();
  return count;
}

BotResult HollowBot::result() const {
  BotResult result = measure_.result(ticks(), connection_.traffic());
  result.ending = ending();
  if (!result.ending && closed()) result.ending = "the connection is lost";
  if (result.joined) result.line = session_->reading();
  return result;
}

}  // namespace platon
