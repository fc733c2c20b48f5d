#include "client/netcode/error_smoothing.h"

#include <algorithm>
#include <cstdint>

namespace platon {

namespace {

// `vector` times part / whole, towards nothing; 0 <= part <= whole.
Point share(Point vector, Moment part, Moment whole) {
  return {static_cast<std::int32_t>(vector.x * part.count() / whole.count()),
          static_cast<std::int32_t>(vector.y * part.count() / whole.count())};
}

}  // namespace

Moment ErrorSmoothing::Fading::left(Moment now) const {
  return std::clamp(kDuration - (now - start), Moment::zero(), kDuration);
}

Point ErrorSmoothing::Fading::at(Moment now) const { return share(whole, left(now), kDuration); }

void ErrorSmoothing::add(Point back, Moment now) {
  while (count_ > 0 && fading_.front().left(now) == Moment::zero()) dropFirst();
  if (count_ == kMax) joinFirstTwo(now);
  fading_[count_++] = {back, now};
}

void ErrorSmoothing::dropFirst() {
  std::move(fading_.begin() + 1, fading_.end(), fading_.begin());
  --count_;
}

// What is left of the first is added to the second in such a way that nothing moves now.
void ErrorSmoothing::joinFirstTwo(Moment now) {
  fading_[1].whole += share(fading_[0].whole, fading_[0].left(now), fading_[1].left(now));
  dropFirst();
}

Point ErrorSmoothing::at(Moment now) const {
  Point sum;
  for (std::size_t i = 0; i < count_; ++i) sum += fading_[i].at(now);
  return sum;
}

}  // namespace platon
