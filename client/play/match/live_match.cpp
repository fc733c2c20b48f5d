#include "client/play/match/live_match.h"

#include <algorithm>

#include "client/lobby/own_addresses.h"

namespace platon {

LiveMatch::LiveMatch(const ClientOptions& options, const MatchChoice& choice, const Clock& clock)
    : choice_(choice), clock_(clock), time_(std::make_shared<PausableClock>(clock.now)) {
  ClientOptions joined = options;
  joined.server = choice.server;
  joined.knowledge = {};
  joined.knowledge.password = choice.password;
  if (!choice.server) {
    server_.emplace(choice.own, time_);
    joined.knowledge = {server_->identity(), Password(choice.own.password)};
  }
  play_.emplace(joined, choice.server ? *choice.server : server_->address(), now(), choice.rival);
}

void LiveMatch::update(bool wantsPause, const Controls& controls) {
  time_->setPaused(wantsPause && alone() && play_->client().welcomed());
  play_->setTimed(!waits());
  applySpeed();
  play_->update(now(), controls);
}

void LiveMatch::setSpeed(double speed) { speed_ = speed; }

// What counts is told before the time runs slower.
void LiveMatch::applySpeed() {
  const double speed = alone() ? speed_ : 1;
  const Session* const session = play_->client().session();
  const std::uint32_t round = session != nullptr && session->round() != nullptr ? session->round()->id() : round_;
  leastSpeed_ = round == round_ ? std::min(leastSpeed_, speed) : speed;
  round_ = round;
  if (server_) server_->countTimes(speed == 1);
  play_->countRuns(speed == 1);
  time_->setSpeed(speed);
}

void LiveMatch::skipLevel() {
  if (!alone()) return play_->toggleVote();
  if (asked_ != round_) server_->startNextLevel();  // it takes a while; a second press would skip the level after it
  asked_ = round_;
}

void LiveMatch::leave() {
  time_->setPaused(false);
  time_->setSpeed(1);
  const Moment pauses = clock_.now() - now();
  play_->leave({[this] { return now(); }, [this, pauses](Moment until) { clock_.sleepUntil(until + pauses); }});
}

std::vector<std::string> LiveMatch::invitation() const {
  if (!server_ || !choice_.own.listens) return {};
  std::string addresses;
  for (const std::string& host : ownAddresses()) {
    addresses += (addresses.empty() ? "" : "  or  ") + ServerAddress{host, server_->address().port}.text();
  }
  if (addresses.empty()) return {"This machine has no network."};
  return {"Others join at " + addresses};
}

}  // namespace platon
