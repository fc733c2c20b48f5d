#include "client/netcode/player_watch.h"

#include <algorithm>
#include <bit>

#include "platon/game/input.h"

namespace platon {

void AttemptTime::observe(std::uint32_t ticks, const PlayerState& player) {
  if (ticks <= newest_) return;
  newest_ = ticks;
  const bool arrives = player.arrived != 0 && !arrived_;
  const bool improves = player.finishTicks != best_;
  arrived_ = player.arrived != 0;
  best_ = player.finishTicks;
  if (player.startedAt == 0) {
    attempt_ = 0;
  } else if (arrives && improves) {
    attempt_ = player.finishTicks;  // exact also if the arrival was predicted too late
  } else if (arrives || !arrived_) {
    attempt_ = ticks - player.startedAt + 1;
  }
}

PlayerState teamOf(const Game& game) {
  PlayerState team;
  const auto least = [](std::uint32_t a, std::uint32_t b) { return a == 0 || (b != 0 && b < a) ? b : a; };
  for (std::uint32_t slot = 0; slot < game.slots(); ++slot) {
    const PlayerState& player = game.player(slot);
    if (player.present == 0) continue;
    team.startedAt = least(team.startedAt, player.startedAt);
    team.finishTicks = least(team.finishTicks, player.finishTicks);
    team.arrived = std::max(team.arrived, player.arrived);
  }
  return team;
}

void PlayerFlashes::observe(std::uint32_t slot, std::uint32_t ticks, const PlayerState& player) {
  if (slot >= players_.size()) players_.resize(slot + 1);
  Observed& observed = players_[slot];
  if (ticks <= observed.newest) return;
  const bool first = observed.newest == 0;
  observed.newest = ticks;
  const bool stands = player.ground != Point();
  const bool lands = stands && observed.airTicks >= kMinAirTicks;
  // A player that had finished before the first observation does not flash.
  const bool finishes = !first && player.finished() && !observed.finished;
  observed.airTicks = stands || player.present == 0 ? 0 : observed.airTicks + 1;
  observed.finished = player.finished();
  if (lands || finishes) observed.flashes[observed.count++ % observed.flashes.size()] = ticks;
}

double PlayerFlashes::brightness(std::uint32_t slot, double tick) const {
  if (slot >= players_.size()) return 0;
  const Observed& observed = players_[slot];
  double brightest = 0;
  for (std::size_t i = 0; i < std::min(observed.count, observed.flashes.size()); ++i) {
    const double age = tick - observed.flashes[i];
    if (age >= 0) brightest = std::max(brightest, 1 - age / kTicks);
  }
  return brightest;
}

namespace {

constexpr int kFacesOfLap = 4;  // at least

// Who has touched the goal may fall as it likes.
bool isFalling(const PlayerState& player) {
  return player.present != 0 && player.arrived == 0 && player.ground == Point() && (player.held & Input::kRestart) == 0;
}

std::uint32_t faceOf(const Game& game, std::uint32_t slot) { return game.world().entities()[slot].part; }

}  // namespace

void FallLaps::enter(std::uint32_t face) {
  if (face == face_) return;
  face_ = face;
  const std::uint32_t bit = std::uint32_t{1} << face;
  if ((faces_ & bit) != 0 && std::popcount(faces_) >= kFacesOfLap) {
    ++count_;
    faces_ = 0;
  }
  faces_ |= bit;
}

void EndlessFall::observe(std::uint32_t ticks, const Game& game, std::uint32_t slot) {
  if (ticks <= newest_) return;
  const bool first = newest_ == 0;
  newest_ = ticks;
  const std::uint32_t crossings = game.world().entities()[slot].crossings;
  if (first || !isFalling(game.player(slot))) {
    grounded_ = ticks;
    groundedCrossings_ = crossings;
    laps_ = {};
    isEndless_ = false;
    held_.reset();
    trial_.reset();
  }
  laps_.enter(faceOf(game, slot));
  crossings_ = crossings - groundedCrossings_;
  if (laps_.count() >= kRestartLaps) restartsUntil_ = ticks + kRestartTicks;
  if (ticks - grounded_ >= kPatience) tryOut(game, slot);
}

// As long as the buttons are the same, the fall is as the first trial foretells.
void EndlessFall::tryOut(const Game& game, std::uint32_t slot) {
  const std::uint8_t held = game.player(slot).held;
  if (held_ != held) beginTrial(game, slot, held);
  held_ = held;
  const std::uint32_t ticks = std::max(kTrialTicks / game.slots(), 1U);
  for (std::uint32_t tick = 0; tick < ticks && trial_; ++tick) {
    if (const std::optional<bool> lands = advanceTrial(slot)) endTrial(game, slot, *lands);
  }
}

void EndlessFall::endTrial(const Game& game, std::uint32_t slot, bool lands) {
  const bool isOfHeld = inputs_[slot].buttons == held_;
  if (!lands && inputs_[slot].buttons != Input::kPresent) return beginTrial(game, slot, Input::kPresent);
  isEndless_ = !lands;
  trial_.reset();
  if (lands && !isOfHeld) held_.reset();  // later, it may be too late to let go of the keys
}

// The others keep their buttons, as in the prediction.
void EndlessFall::beginTrial(const Game& game, std::uint32_t slot, std::uint8_t buttons) {
  trial_ = game;
  trialLaps_ = {};
  trialTicks_ = 0;
  inputs_.clear();
  for (std::uint32_t other = 0; other < game.slots(); ++other) inputs_.push_back({game.player(other).held});
  inputs_[slot] = {buttons};
}

// Whether the player lands; nothing yet while that is open.
std::optional<bool> EndlessFall::advanceTrial(std::uint32_t slot) {
  trial_->advance(inputs_);
  trialLaps_.enter(faceOf(*trial_, slot));
  if (!isFalling(trial_->player(slot))) return true;
  const bool isOpen = trialLaps_.count() < kHintLaps && ++trialTicks_ < kMaxTrialTicks;
  return isOpen ? std::nullopt : std::optional(false);
}

}  // namespace platon
