#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "server/base/time_point.h"

namespace platon {

enum class LogFormat { kText, kJson };

/// A key and its value in a log line. The key is none of `time`, `level` and `message`, which the line has already.
struct LogField {
  std::string_view key;
  std::variant<std::uint64_t, std::string> value;
};

/// The server's log: one line per event, either `message key=value …` or a JSON object that also has the time (UTC).
class Log {
 public:
  /// `sink` receives each line, without a line feed.
  Log(LogFormat format, std::function<void(std::string_view)> sink) : format_(format), sink_(std::move(sink)) {}

  void setFormat(LogFormat format) { format_ = format; }

  void info(std::string_view message, const std::vector<LogField>& fields = {}) { write("info", message, fields); }
  void warning(std::string_view message, const std::vector<LogField>& fields = {}) {
    write("warning", message, fields);
  }

 private:
  void write(std::string_view severity, std::string_view message, const std::vector<LogField>& fields);

  LogFormat format_;
  std::function<void(std::string_view)> sink_;
};

/// Which refusals of banned addresses the log tells of: at most one in ten seconds, and one of each household in an
/// hour.
class BanNotices {
 public:
  static constexpr std::chrono::seconds kInterval{10};
  static constexpr std::chrono::hours kHouseholdInterval{1};

  /// A household (IpAddress::household) was refused. Whether to tell of it. `now` never decreases.
  bool take(std::uint64_t household, TimePoint now) {
    while (!told_.empty() && now - told_.front().at >= kHouseholdInterval) told_.pop_front();
    if (!told_.empty() && now - told_.back().at < kInterval) return false;
    if (std::any_of(told_.begin(), told_.end(), [&](const Notice& each) { return each.household == household; })) {
      return false;
    }
    told_.push_back({household, now});
    return true;
  }

  /// Households that it remembers: at most kHouseholdInterval / kInterval.
  std::size_t size() const { return told_.size(); }

 private:
  struct Notice {
    std::uint64_t household;
    TimePoint at;
  };

  std::deque<Notice> told_;  // oldest first
};

}  // namespace platon
