#include "server/app/log.h"

#include <cassert>
#include <chrono>

#include <fmt/chrono.h>
#include <fmt/format.h>

#include "protocol/texts.h"

namespace platon {
namespace {

std::string valueOf(const LogField& field) {
  if (const auto* number = std::get_if<std::uint64_t>(&field.value)) return std::to_string(*number);
  return jsonText(std::get<std::string>(field.value));
}

std::string utcTime() {
  const auto now = std::chrono::time_point_cast<std::chrono::milliseconds>(std::chrono::system_clock::now());
  return fmt::format("{:%Y-%m-%dT%H:%M:%S}.{:03}Z", fmt::gmtime(std::chrono::system_clock::to_time_t(now)),
                     now.time_since_epoch().count() % 1000);
}

}  // namespace

void Log::write(std::string_view severity, std::string_view message, const std::vector<LogField>& fields) {
  const bool json = format_ == LogFormat::kJson;
  std::string line(message);
  if (json) line = fmt::format(R"({{"time":"{}","level":"{}","message":{})", utcTime(), severity, jsonText(message));
  for (const LogField& field : fields) {
    assert(field.key != "time" && field.key != "level" && field.key != "message");  // a JSON object has each key once
    line +=
        json ? fmt::format(R"(,"{}":{})", field.key, valueOf(field)) : fmt::format(" {}={}", field.key, valueOf(field));
  }
  if (json) line += '}';
  sink_(line);
}

}  // namespace platon
