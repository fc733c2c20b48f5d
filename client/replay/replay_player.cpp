#include "client/replay/replay_player.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace platon {
namespace {

constexpr std::array<double, 5> kSpeeds{0.25, 0.5, 1, 2, 4};

}  // namespace

ReplayPlayer::ReplayPlayer(std::shared_ptr<const Replay> replay)
    : replay_(std::move(replay)), game_(replay_->gameAfter(0)) {
  show();
}

// The picture is between the last tick and the one before, so a tick is played when its first part is to be seen.
void ReplayPlayer::advance(double seconds) {
  if (paused_) return;
  fraction_ += seconds * kTicksPerSecond * speed();
  for (; fraction_ > 1 && tick_ < replay_->ticks(); fraction_ -= 1) playTick();
  if (fraction_ <= 1) return;
  fraction_ = 1;
  paused_ = true;
}

void ReplayPlayer::skipTo(double seconds) {
  const double passed = std::min(seconds * kTicksPerSecond, static_cast<double>(replay_->ticks()));
  paused_ = passed < seconds * kTicksPerSecond;
  const double last = std::ceil(passed);
  seek(static_cast<std::uint32_t>(std::max(last - 1, 0.0)));
  if (last > 0) playTick();
  fraction_ = last > 0 ? passed - last + 1 : 1;
}

void ReplayPlayer::togglePause() {
  if (paused_ && tick_ == replay_->ticks()) seek(0);
  paused_ = !paused_;
}

void ReplayPlayer::step(std::int32_t ticks) {
  paused_ = true;
  const std::int64_t target = std::int64_t{tick_} + ticks;
  if (ticks == 1 && tick_ < replay_->ticks()) {
    playTick();
    fraction_ = 1;
  } else {
    seek(static_cast<std::uint32_t>(std::max<std::int64_t>(target, 0)));
  }
}

void ReplayPlayer::seek(std::uint32_t tick) {
  tick_ = std::min(tick, replay_->ticks());
  game_ = replay_->gameAfter(tick_);
  show();
}

void ReplayPlayer::faster() { speed_ = std::min<std::uint32_t>(speed_ + 1, kSpeeds.size() - 1); }

void ReplayPlayer::slower() { speed_ = std::max(speed_, 1U) - 1; }

double ReplayPlayer::speed() const { return kSpeeds[speed_]; }

void ReplayPlayer::followNext() {
  const std::uint32_t current = followed();
  for (std::uint32_t i = 1; i <= game_.slots(); ++i) {
    followed_ = (current + i) % game_.slots();
    if (isPresent(followed_)) return;
  }
}

std::uint32_t ReplayPlayer::followed() const {
  if (isPresent(followed_)) return followed_;
  for (std::uint32_t slot = 0; slot < game_.slots(); ++slot) {
    if (isPresent(slot)) return slot;
  }
  return followed_;
}

void ReplayPlayer::playTick() {
  before_ = now_;
  game_.advance(replay_->inputsOf(tick_++));
  look();
}

void ReplayPlayer::look() {
  now_.clear();
  for (std::uint32_t slot = 0; slot < game_.slots(); ++slot) now_.push_back(snapshotOf(game_, slot));
}

// Shows the game as it is, without motion.
void ReplayPlayer::show() {
  look();
  before_ = now_;
  fraction_ = 1;
}

}  // namespace platon
