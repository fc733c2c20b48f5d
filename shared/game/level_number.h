#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace platon {

/// A decimal number of a level text, exact.
struct LevelNumber {
  static constexpr int kMaxDecimals = 4;
  static constexpr std::int64_t kOne = 10000;

  std::int64_t tenThousandths = 0;

  /// The value in level units; for numbers without decimals.
  std::int64_t whole() const { return tenThousandths / kOne; }
  /// The value in subunits, rounded to the nearest. There are no ties: 0.0001 units are 64/625 subunits, and 625 is
  /// odd.
  std::int32_t subunits() const;
};

/// Error of parseNumber.
enum class NumberFault : std::uint8_t { kNone, kNotANumber, kTooManyDecimals, kTooLarge };

/// Parses an optional `-`, digits, and optionally a point with 1 … 4 digits. The magnitude must not exceed `limit`,
/// which is below 2^31. Sets `number` when the result is kNone.
NumberFault parseNumber(std::string_view text, std::int64_t limit, LevelNumber& number);

}  // namespace platon
