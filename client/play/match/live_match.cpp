#include "client/play/match/live_match.h"

#include <cstdio>

#include "client/files/user_folders.h"
#include "client/lobby/own_addresses.h"

namespace platon {
namespace {

// What the demonstration reaches is nothing that the user has reached.
std::filesystem::path reachedFileOf(const ClientOptions& options) {
  return options.demo ? std::filesystem::path() : reachedLevelsFile();
}

const Round* roundOf(const MatchPlay& play) {
  return play.client().session() == nullptr ? nullptr : play.client().session()->round();
}

// The player of this program in the confirmed game; null if it has none.
const PlayerState* localPlayer(const Round& round) {
  const Prediction& prediction = round.prediction();
  const Game& game = prediction.confirmed();
  return prediction.slot() < game.slots() ? &game.player(prediction.slot()) : nullptr;
}

}  // namespace

LiveMatch::LiveMatch(const ClientOptions& options, const MatchChoice& choice, const Clock& clock)
    : choice_(choice),
      clock_(clock),
      reached_(reachedFileOf(options)),
      time_(std::make_shared<PausableClock>(clock.now)) {
  ClientOptions joined = options;
  joined.server = choice.server;
  joined.knowledge = {choice.key, choice.password};
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
  noteGoal();
}

// Also an attempt whose time does not count has reached the goal.
void LiveMatch::noteGoal() {
  const Round* const round = roundOf(*play_);
  const PlayerState* const player = round == nullptr ? nullptr : localPlayer(*round);
  if (player == nullptr || player->arrived == 0 || !alone()) return;
  const std::string fault = reached_.add(round->prediction().confirmed().level().hash);
  if (!fault.empty()) std::fprintf(stderr, "platon-client: %s\n", fault.c_str());
}

void LiveMatch::setSpeed(double speed) { speed_ = speed; }

// What counts is told before the time runs slower.
void LiveMatch::applySpeed() {
  const double speed = alone() ? speed_ : 1;
  const Round* const round = roundOf(*play_);
  const PlayerState* const player = round == nullptr ? nullptr : localPlayer(*round);
  if (player != nullptr) attempt_.observe(round->id(), *player, speed);
  if (server_) server_->countTimes(speed == 1);
  play_->countRuns(speed == 1);
  time_->setSpeed(speed);
}

void LiveMatch::skipLevel() {
  if (!alone()) return play_->toggleVote();
  const Round* const round = roundOf(*play_);
  const std::uint32_t present = round == nullptr ? 0 : round->id();
  if (asked_ != present) server_->startNextLevel();  // it takes a while; a second press would skip the level after it
  asked_ = present;
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
    addresses += (addresses.empty() ? "" : " or ") + ServerAddress{host, server_->address().port}.text();
  }
  if (addresses.empty()) return {"This machine has no network."};
  return {"Others join at " + addresses};
}

}  // namespace platon
