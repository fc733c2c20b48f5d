#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>

namespace platon {

/// A time of the calendar, in UTC, to the second.
using UtcTime = std::chrono::sys_seconds;

/// Reads `2026-12-01T18:00:00Z`, or `2026-12-01`, which is its midnight. The year is 1970 … 9999. Nothing if the text
/// is no such time.
std::optional<UtcTime> parseUtcTime(std::string_view text);
/// `2026-12-01T18:00:00Z`
std::string formatUtcTime(UtcTime time);

/// Longest duration that `parseDuration` reads: ten years.
inline constexpr std::chrono::days kMaxDuration{3650};

/// Reads a number and a unit: `90s`, `30m`, `2h`, `7d` or `4w`. Nothing if the text is no such duration, or one of
/// zero, or longer than kMaxDuration.
std::optional<std::chrono::seconds> parseDuration(std::string_view text);

}  // namespace platon
