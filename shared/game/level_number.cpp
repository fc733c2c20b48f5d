#include "shared/game/level_number.h"

#include <algorithm>
#include <cstddef>

#include "platon/exact/integer.h"

namespace platon {
namespace {

bool allDigits(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

// `value` with decimal digits appended. Stops growing beyond 2^40, above every limit, so that it cannot overflow.
std::int64_t append(std::int64_t value, std::string_view digits) {
  constexpr std::int64_t beyond = std::int64_t{1} << 40;
  for (const char digit : digits) {
    if (value < beyond) value = value * 10 + (digit - '0');
  }
  return value;
}

}  // namespace

std::int32_t LevelNumber::subunits() const {
  return static_cast<std::int32_t>(divideRounded(tenThousandths * kSubunitsPerUnit, kOne));
}

NumberFault parseNumber(std::string_view text, std::int64_t limit, LevelNumber& number) {
  const bool negative = text.starts_with('-');
  if (negative) text.remove_prefix(1);
  const std::size_t point = std::min(text.find('.'), text.size());
  const std::string_view whole = text.substr(0, point);
  const bool hasPoint = point < text.size();
  const std::string_view decimals = hasPoint ? text.substr(point + 1) : std::string_view();
  if (!allDigits(whole) || (hasPoint && !allDigits(decimals))) return NumberFault::kNotANumber;
  if (decimals.size() > LevelNumber::kMaxDecimals) return NumberFault::kTooManyDecimals;
  const std::int64_t units = append(0, whole);
  if (units > limit) return NumberFault::kTooLarge;
  std::int64_t value = append(units, decimals);
  for (std::size_t i = decimals.size(); i < LevelNumber::kMaxDecimals; ++i) value *= 10;
  if (value > limit * LevelNumber::kOne) return NumberFault::kTooLarge;
  number.tenThousandths = negative ? -value : value;
  return NumberFault::kNone;
}

}  // namespace platon
