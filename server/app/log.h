#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

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

}  // namespace platon
