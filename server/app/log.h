#pragma once

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <string>
#include <string_view>
#include <variant>

namespace platon {

enum class LogFormat { kText, kJson };

/// One thing said about an event.
struct LogField {
  std::string_view key;
  std::variant<std::uint64_t, std::string> value;
};

/// What a server tells its operator: one line an event, either `message key=value …` or a JSON object that also has
/// the time of day.
class Log {
 public:
  /// `sink` takes each line, without its end.
  Log(LogFormat format, std::function<void(std::string_view)> sink) : format_(format), sink_(std::move(sink)) {}
  /// Writes to standard error.
  explicit Log(LogFormat format);

  void setFormat(LogFormat format) { format_ = format; }

  void info(std::string_view message, std::initializer_list<LogField> fields = {}) { write("info", message, fields); }
  void warning(std::string_view message, std::initializer_list<LogField> fields = {}) {
    write("warning", message, fields);
  }

 private:
  void write(std::string_view severity, std::string_view message, std::initializer_list<LogField> fields);

  LogFormat format_;
  std::function<void(std::string_view)> sink_;
};

}  // namespace platon
