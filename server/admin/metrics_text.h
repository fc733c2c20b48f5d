#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace platon {

/// A value of a metric.
struct MetricSample {
  std::string value;                                             ///< a number that is not negative
  std::vector<std::pair<std::string_view, std::string>> labels;  ///< names and values, in UTF-8
  std::string_view suffix;                                       ///< of the name: "_sum" or "_count" of a summary
};

/// What a server reports under one name.
struct Metric {
  std::string_view name;
  std::string_view type;  ///< "counter", which ends with _total and counts since the start, "gauge" or "summary"
  std::string_view help;  ///< a sentence without \ and line feeds
  std::vector<MetricSample> samples;
};

/// A time in microseconds as a decimal number of seconds, exactly.
std::string secondsText(std::uint64_t microseconds);

/// The metrics in the text format of Prometheus, version 0.0.4.
std::string formatMetrics(std::span<const Metric> metrics);

}  // namespace platon
