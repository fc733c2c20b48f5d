#include "client/netcode/prediction.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>

namespace platon {

namespace {

constexpr int kMaxWarps = 3;                                   // enough for any two faces within a correction
constexpr std::int32_t kMaxSmoothed = 100 * kSubunitsPerUnit;  // larger corrections are shown at once

std::int32_t roundedLengthOf(Point vector) {
  return static_cast<std::int32_t>(std::lround(std::sqrt(static_cast<double>(squaredLength(vector)))));
}

Input at(std::span<const Input> inputs, std::size_t slot) { return slot < inputs.size() ? inputs[slot] : Input{}; }

}  // namespace

Time ErrorSmoothing::Correction::remaining(Time now) const {
  return std::clamp(kDuration - (now - start), Time::zero(), kDuration);
}

Point ErrorSmoothing::Correction::at(Time now) const {
  const std::int64_t left = remaining(now).count();
  return {static_cast<std::int32_t>(offset.x * left / kDuration.count()),
          static_cast<std::int32_t>(offset.y * left / kDuration.count())};
}

void ErrorSmoothing::add(Point offset, Time now) {
  while (count_ > 0 && corrections_.front().remaining(now) == Time::zero()) dropOldest();
  if (count_ == kMaxCorrections) dropOldest();
  corrections_[count_++] = {offset, now};
}

void ErrorSmoothing::dropOldest() {
  std::move(corrections_.begin() + 1, corrections_.end(), corrections_.begin());
  --count_;
}

Point ErrorSmoothing::at(Time now) const {
  Point sum;
  for (std::size_t i = 0; i < count_; ++i) sum += corrections_[i].at(now);
  return sum;
}

Prediction::Prediction(const Game& start, std::uint32_t slot)
    : slot_(slot), confirmed_(start), predicted_(start), held_(slot + 1) {
  assert(slot < kMaxPlayers);
}

bool Prediction::present() const { return slot_ < confirmed_.slots() && confirmed_.player(slot_).present != 0; }

// The tick of a full state comes from the server and may be close to 2^32.
std::uint32_t Prediction::maxAhead() const {
  return std::min({kMaxAhead, kMaxWorkAhead / workOfTick(), UINT32_MAX - confirmedTicks_});
}

std::uint32_t Prediction::workOfTick() const { return others_ + 1; }

void Prediction::predict(Input local) {
  assert(mayPredict());
  localInputs_[predictedTicks_ % kMaxAhead] = local;
  advancePredicted(local);
  firstPredicted_[(predictedTicks_ - 1) % kMaxAhead] = localPlace(predicted_);
}

void Prediction::advancePredicted(Input local) {
  inputs_ = held_;
  inputs_[slot_] = local;
  const std::span<const EntityState> entities = predicted_.world().entities();
  predictedBefore_.assign(entities.begin(), entities.end());
  predicted_.advance(inputs_);
  work_ += workOfTick();
  ++predictedTicks_;
}

void Prediction::confirm(std::span<const Input> inputs) {
  assert(inputs.size() <= kMaxPlayers);
  const bool wasPredicted = confirmedTicks_ < predictedTicks_;
  if (wasPredicted) held_[slot_] = localInput(confirmedTicks_);
  if (wasPredicted && present() && at(inputs, slot_) != held_[slot_]) ++statistics_.missedInputs;
  const std::size_t slots = std::max(inputs.size(), held_.size());
  for (std::size_t slot = 0; slot < slots; ++slot) stale_ |= at(inputs, slot) != at(held_, slot);
  hold(inputs);
  confirmed_.advance(held_);
  work_ += workOfTick();
  ++confirmedTicks_;
  ++statistics_.confirmedTicks;
  if (wasPredicted) countMisprediction();
}

void Prediction::countMisprediction() {
  const std::optional<Place>& predicted = firstPredicted_[(confirmedTicks_ - 1) % kMaxAhead];
  const std::optional<Place> confirmed = localPlace(confirmed_);
  if (predicted && confirmed && *predicted != *confirmed) ++statistics_.mispredicted;
}

void Prediction::hold(std::span<const Input> inputs) {
  held_.assign(inputs.begin(), inputs.end());
  held_.resize(std::max<std::size_t>(inputs.size(), slot_ + 1));
  const auto present = std::count_if(held_.begin(), held_.end(), [](Input each) { return each.has(Input::kPresent); });
  others_ = static_cast<std::uint32_t>(present) - (held_[slot_].has(Input::kPresent) ? 1 : 0);
}

bool Prediction::restore(std::span<const std::uint8_t> state, std::uint32_t ticks, std::span<const Input> held) {
  if (!confirmed_.restore(state)) return false;
  confirmedTicks_ = ticks;
  hold(held);
  stale_ = true;
  return true;
}

void Prediction::reconcile(Time now) {
  if (!stale_ && confirmedTicks_ <= predictedTicks_) return;
  stale_ = false;
  const std::uint32_t until = std::clamp(predictedTicks_, confirmedTicks_, confirmedTicks_ + maxAhead());
  const std::optional<Place> before = until == predictedTicks_ ? localPlace(predicted_) : std::nullopt;
  replay(until);
  if (before) correct(*before, now);
}

void Prediction::replay(std::uint32_t until) {
  predicted_ = confirmed_;
  predictedTicks_ = confirmedTicks_;
  while (predictedTicks_ < until) advancePredicted(localInput(predictedTicks_));
}

// Returns nothing until the local player is present: before that, nothing can be mispredicted.
std::optional<Place> Prediction::localPlace(const Game& game) const {
  if (!present() || slot_ >= game.slots() || game.player(slot_).present == 0) return std::nullopt;
  const EntityState& entity = game.world().entities()[slot_];
  return Place{entity.part, entity.position};
}

void Prediction::correct(const Place& before, Time now) {
  const std::optional<Place> after = localPlace(predicted_);
  if (!after || *after == before) return;
  const Geometry& geometry = predicted_.world().geometry();
  const std::optional<Point> old = unfold(geometry, before, after->part, after->position, kMaxWarps);
  if (!old) return;
  const Point offset = *old - after->position;
  const std::int32_t distance = roundedLengthOf(offset);
  ++statistics_.corrections;
  statistics_.lastSubunits = distance;
  statistics_.maxSubunits = std::max(statistics_.maxSubunits, distance);
  if (distance > kMaxSmoothed) {
    smoothing_.clear();
  } else {
    smoothing_.add(rotate(offset, -predicted_.world().entities()[slot_].angle), now);
  }
}

}  // namespace platon
