#pragma once

#include <algorithm>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

namespace platon {

/// Reads the text format of Prometheus, version 0.0.4, as its description says, and shares no code with the formatter:
/// https://prometheus.io/docs/instrumenting/exposition_formats/#text-format-details
class MetricsReader {
 public:
  explicit MetricsReader(const std::string& text) {
    EXPECT_TRUE(text.empty() || text.back() == '\n') << "the last line must end with a line feed";
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) read(line);
    for (const auto& [name, type] : types) EXPECT_TRUE(helps.contains(name)) << name;
  }

  std::map<std::string, std::string> types;   // by name of the metric
  std::map<std::string, std::string> helps;   // by name of the metric
  std::map<std::string, std::string> values;  // by name and labels, as they stand there

 private:
  void read(const std::string& line) {
    static const std::regex help("# HELP ([a-zA-Z_:][a-zA-Z0-9_:]*) ((?:[^\\\\\\n]|\\\\\\\\|\\\\n)*)");
    static const std::regex type("# TYPE ([a-zA-Z_:][a-zA-Z0-9_:]*) (counter|gauge|histogram|summary|untyped)");
    static const std::regex sampleLine(
        "(([a-zA-Z_:][a-zA-Z0-9_:]*)(?:\\{([a-zA-Z_][a-zA-Z0-9_]*=\"(?:[^\"\\\\\\n]|\\\\\\\\|\\\\\"|\\\\n)*\""
        "(?:,[a-zA-Z_][a-zA-Z0-9_]*=\"(?:[^\"\\\\\\n]|\\\\\\\\|\\\\\"|\\\\n)*\")*)\\})?) ([0-9]+(?:\\.[0-9]+)?)");
    std::smatch match;
    if (std::regex_match(line, match, help)) {
      EXPECT_TRUE(helps.emplace(match[1], match[2]).second) << "second HELP of " << match[1];
      begin(match[1]);
    } else if (std::regex_match(line, match, type)) {
      EXPECT_TRUE(types.emplace(match[1], match[2]).second) << "second TYPE of " << match[1];
      EXPECT_EQ(current_, match[1]) << "TYPE outside its group";
      EXPECT_FALSE(hasSample_) << "TYPE after a sample of " << match[1];
    } else if (std::regex_match(line, match, sampleLine)) {
      EXPECT_EQ(metricOf(match[2]), current_) << "the lines of a metric must form one group";
      EXPECT_TRUE(values.emplace(match[1], match[4]).second) << "second sample of " << match[1];
      hasSample_ = true;
    } else {
      ADD_FAILURE() << "not a line of the format: " << line;
    }
  }

  void begin(const std::string& name) {
    EXPECT_TRUE(begun_.insert(name).second) << "second group of " << name;
    current_ = name;
    hasSample_ = false;
  }

  // Samples of a summary may have the suffixes _sum and _count.
  std::string metricOf(const std::string& sampleName) const {
    for (const std::string suffix : {"_sum", "_count"}) {
      const std::string base = sampleName.substr(0, sampleName.size() - std::min(sampleName.size(), suffix.size()));
      const auto found = types.find(base);
      if (sampleName.ends_with(suffix) && found != types.end() && found->second == "summary") return base;
    }
    return sampleName;
  }

  std::string current_;
  bool hasSample_ = false;
  std::set<std::string> begun_;
};

}  // namespace platon
