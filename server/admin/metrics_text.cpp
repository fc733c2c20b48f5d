#include "server/admin/metrics_text.h"

#include <array>
#include <cstdio>

namespace platon {
namespace {

std::string escaped(std::string_view text) {
  std::string result;
  for (const char byte : text) {
    if (byte == '\\' || byte == '"') result += '\\';
    if (byte == '\n')
      result += "\\n";
    else
      result += byte;
  }
  return result;
}

void append(std::string& text, std::string_view name, const MetricSample& sample) {
  text.append(name).append(sample.suffix);
  char separator = '{';
  for (const auto& [label, content] : sample.labels) {
    text.append(1, separator).append(label).append("=\"").append(escaped(content)).append("\"");
    separator = ',';
  }
  text.append(sample.labels.empty() ? " " : "} ").append(sample.value).append("\n");
}

}  // namespace

std::string secondsText(std::uint64_t microseconds) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%llu.%06llu", static_cast<unsigned long long>(microseconds / 1'000'000),
                static_cast<unsigned long long>(microseconds % 1'000'000));
  return text.data();
}

std::string formatMetrics(std::span<const Metric> metrics) {
  std::string text;
  for (const Metric& metric : metrics) {
    text.append("# HELP ").append(metric.name).append(" ").append(metric.help).append("\n");
    text.append("# TYPE ").append(metric.name).append(" ").append(metric.type).append("\n");
    for (const MetricSample& sample : metric.samples) append(text, metric.name, sample);
  }
  return text;
}

}  // namespace platon
