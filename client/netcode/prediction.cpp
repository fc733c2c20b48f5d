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

Prediction::Prediction(const Game& start, const SlotsByLocal& slots)
    : slots_(slots), confirmed_(start), predicted_(start) {
  hold({});
}

// The inputs and places of who had the local number before mean nothing any more.
void Prediction::setSlots(const SlotsByLocal& slots) {
  for (std::size_t local = 0; local < slots.size(); ++local) {
    if (slots[local] == slots_[local]) continue;
    for (InputsByLocal& inputs : localInputs_) inputs[local] = Input();
    for (PlacesByLocal& places : firstPredicted_) places[local].reset();
    smoothing_[local].clear();
    stale_ = true;
  }
  slots_ = slots;
  hold(std::vector<Input>(held_));
}

bool Prediction::isPresent(std::uint32_t slot) const {
  return slot < confirmed_.slots() && confirmed_.player(slot).present != 0;
}

// The tick of a full state comes from the server and may be close to 2^32.
std::uint32_t Prediction::maxAhead() const {
  return std::min({kMaxAhead, kMaxWorkAhead / players_, UINT32_MAX - confirmedTicks_});
}

void Prediction::predict(const InputsByLocal& local) {
  assert(mayPredict());
  localInputs_[predictedTicks_ % kMaxAhead] = local;
  advancePredicted(local);
  firstPredicted_[(predictedTicks_ - 1) % kMaxAhead] = localPlaces(predicted_);
}

// Writes the inputs of the local players into those of all.
void Prediction::holdLocal(const InputsByLocal& local, std::vector<Input>& inputs) const {
  for (std::size_t i = 0; i < local.size(); ++i)
    if (slots_[i] && local[i].has(Input::kPresent)) inputs[*slots_[i]] = local[i];
}

void Prediction::advancePredicted(const InputsByLocal& local) {
  inputs_ = held_;
  holdLocal(local, inputs_);
  const std::span<const EntityState> entities = predicted_.world().entities();
  predictedBefore_.assign(entities.begin(), entities.end());
  predicted_.advance(inputs_);
  work_ += players_;
  ++predictedTicks_;
}

void Prediction::confirm(std::span<const Input> inputs) {
  assert(inputs.size() <= kMaxPlayers);
  const bool wasPredicted = confirmedTicks_ < predictedTicks_;
  if (wasPredicted) {
    holdLocal(localInputs(confirmedTicks_), held_);
    countMissed(inputs);
  }
  const std::size_t slots = std::max(inputs.size(), held_.size());
  for (std::size_t slot = 0; slot < slots; ++slot) stale_ |= at(inputs, slot) != at(held_, slot);
  hold(inputs);
  confirmed_.advance(held_);
  work_ += players_;
  ++confirmedTicks_;
  ++statistics_.confirmedTicks;
  if (wasPredicted) countMispredictions();
}

// `inputs` are what the server has decided for a tick for which held_ has what was predicted.
void Prediction::countMissed(std::span<const Input> inputs) {
  for (const std::optional<std::uint32_t>& slot : slots_)
    if (slot && isPresent(*slot) && at(inputs, *slot) != held_[*slot]) ++statistics_.missedInputs;
}

void Prediction::countMispredictions() {
  const PlacesByLocal& predicted = firstPredicted_[(confirmedTicks_ - 1) % kMaxAhead];
  const PlacesByLocal confirmed = localPlaces(confirmed_);
  for (std::size_t local = 0; local < slots_.size(); ++local)
    if (predicted[local] && confirmed[local] && *predicted[local] != *confirmed[local]) ++statistics_.mispredicted;
}

void Prediction::hold(std::span<const Input> inputs) {
  std::size_t size = inputs.size();
  for (const std::optional<std::uint32_t>& slot : slots_) size = std::max<std::size_t>(size, slot ? *slot + 1 : 0);
  held_.assign(inputs.begin(), inputs.end());
  held_.resize(size);
  players_ = 0;
  for (std::uint32_t slot = 0; slot < size; ++slot)
    players_ += held_[slot].has(Input::kPresent) || isLocal(slot) ? 1 : 0;
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
  const PlacesByLocal before = until == predictedTicks_ ? localPlaces(predicted_) : PlacesByLocal();
  replay(until);
  const PlacesByLocal after = localPlaces(predicted_);
  for (std::size_t local = 0; local < slots_.size(); ++local)
    if (before[local] && after[local] && *before[local] != *after[local])
      correct(local, *before[local], *after[local], now);
}

void Prediction::replay(std::uint32_t until) {
  predicted_ = confirmed_;
  predictedTicks_ = confirmedTicks_;
  while (predictedTicks_ < until) advancePredicted(localInputs(predictedTicks_));
}

// Nothing until the player is present in both games: before that, nothing can be mispredicted.
Prediction::PlacesByLocal Prediction::localPlaces(const Game& game) const {
  PlacesByLocal places;
  for (std::size_t local = 0; local < slots_.size(); ++local) {
    const std::optional<std::uint32_t>& slot = slots_[local];
    if (!slot || !isPresent(*slot) || *slot >= game.slots() || game.player(*slot).present == 0) continue;
    const EntityState& entity = game.world().entities()[*slot];
    places[local] = Place{entity.part, entity.position};
  }
  return places;
}

void Prediction::correct(std::size_t local, const Place& before, const Place& after, Time now) {
  const Geometry& geometry = predicted_.world().geometry();
  const std::optional<Point> old = unfold(geometry, before, after.part, after.position, kMaxWarps);
  if (!old) return;
  const Point offset = *old - after.position;
  const std::int32_t distance = roundedLengthOf(offset);
  ++statistics_.corrections;
  statistics_.lastSubunits = distance;
  statistics_.maxSubunits = std::max(statistics_.maxSubunits, distance);
  if (distance > kMaxSmoothed) {
    smoothing_[local].clear();
  } else {
    smoothing_[local].add(rotate(offset, -predicted_.world().entities()[*slots_[local]].angle), now);
  }
}

}  // namespace platon
