#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace platon {

/// A number of a level text, exactly.
struct LevelNumber {
  static constexpr int kMaxDecimals = 4;
  static constexpr std::int64_t kOne = 10000;

  std::int64_t tenThousandths = 0;

  /// Of a number without decimals.
  std::int64_t whole() const { return tenThousandths / kOne; }
  /// To the nearest subunit. There are no halves: a ten-thousandth of a unit is 64/625 subunits, and 625 is odd.
  std::int32_t subunits() const;
};

/// Why a token is no number.
enum class NumberFault : std::uint8_t { kNone, kNotANumber, kTooManyDecimals, kTooLarge };

/// Reads `-`, digits, and perhaps a point and 1 … 4 digits; the value must not exceed `limit` in magnitude, which is
/// below 2^31. `number` is set when there is no fault.
NumberFault parseNumber(std::string_view text, std::int64_t limit, LevelNumber& number);

}  // namespace platon
