#include "client/correction_fade.h"

#include <algorithm>
#include <cstdint>

namespace platon {

void CorrectionFade::add(Point back, Moment now) {
  offset_ = at(now) + back;
  start_ = now;
}

Point CorrectionFade::at(Moment now) const {
  const std::int64_t whole = kDuration.count();
  const std::int64_t left = std::clamp<std::int64_t>(whole - (now - start_).count(), 0, whole);
  return {static_cast<std::int32_t>(offset_.x * left / whole), static_cast<std::int32_t>(offset_.y * left / whole)};
}

}  // namespace platon
