#include "client/play/live_match.h"

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
  play_->update(now(), controls);
}

void LiveMatch::skipLevel() {
  if (alone()) return server_->startNextLevel();
  play_->toggleVote();
}

void LiveMatch::leave() {
  time_->setPaused(false);
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
