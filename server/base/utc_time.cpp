#include "server/base/utc_time.h"

#include <array>
#include <charconv>
#include <cstdio>

namespace platon {
namespace {

using std::chrono::seconds;

// The value of a text of digits; nothing if it has another character or is empty.
std::optional<int> digits(std::string_view text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = error == std::errc() && end == text.data() + text.size();
  return whole && text.front() != '-' ? std::optional(value) : std::nullopt;
}

// The text with every digit replaced by 0.
std::string shapeOf(std::string_view text) {
  std::string shape(text);
  for (char& byte : shape) byte = byte >= '0' && byte <= '9' ? '0' : byte;
  return shape;
}

std::optional<UtcTime> dayOf(std::string_view text) {
  using namespace std::chrono;
  const year_month_day date(year(*digits(text.substr(0, 4))), month(static_cast<unsigned>(*digits(text.substr(5, 2)))),
                            day(static_cast<unsigned>(*digits(text.substr(8, 2)))));
  if (!date.ok() || date.year() < year(1970)) return std::nullopt;
  return sys_days(date);
}

seconds unitOf(char letter) {
  switch (letter) {
    case 's':
      return seconds(1);
    case 'm':
      return std::chrono::minutes(1);
    case 'h':
      return std::chrono::hours(1);
    case 'd':
      return std::chrono::days(1);
    case 'w':
      return std::chrono::weeks(1);
    default:
      return seconds(0);
  }
}

}  // namespace

std::optional<UtcTime> parseUtcTime(std::string_view text) {
  const std::string shape = shapeOf(text);
  if (shape == "0000-00-00") return dayOf(text);
  if (shape != "0000-00-00T00:00:00Z") return std::nullopt;
  const auto day = dayOf(text);
  const int hour = *digits(text.substr(11, 2));
  const int minute = *digits(text.substr(14, 2));
  const int second = *digits(text.substr(17, 2));
  if (!day || hour > 23 || minute > 59 || second > 59) return std::nullopt;
  return *day + std::chrono::hours(hour) + std::chrono::minutes(minute) + seconds(second);
}

std::string formatUtcTime(UtcTime time) {
  const auto midnight = std::chrono::floor<std::chrono::days>(time);
  const std::chrono::year_month_day date(midnight);
  const std::chrono::hh_mm_ss clock(time - midnight);
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%04d-%02u-%02uT%02d:%02d:%02dZ", static_cast<int>(date.year()),
                static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()),
                static_cast<int>(clock.hours().count()), static_cast<int>(clock.minutes().count()),
                static_cast<int>(clock.seconds().count()));
  return text.data();
}

std::optional<seconds> parseDuration(std::string_view text) {
  if (text.size() < 2) return std::nullopt;
  const auto count = digits(text.substr(0, text.size() - 1));
  const seconds unit = unitOf(text.back());
  if (!count || *count == 0 || unit == seconds(0) || *count > seconds(kMaxDuration) / unit) return std::nullopt;
  return *count * unit;
}

}  // namespace platon
