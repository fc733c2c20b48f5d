#include "client/quality/benchmark_report.h"

#include <cstddef>
#include <cstdio>

#include "client/quality/quality_meter.h"
#include "protocol/texts.h"

namespace platon {
namespace {

// `format` for the name of the quality, four times in milliseconds and the number of draw calls.
std::string line(const char* format, const FrameCost& cost) {
  std::array<char, 160> text{};
  const std::string name(namedQuality(cost.quality).name);
  std::snprintf(text.data(), text.size(), format, name.c_str(), cost.p50Ms, cost.p99Ms, cost.allCpuMs, cost.ownCpuMs,
                cost.drawCalls);
  return text.data();
}

}  // namespace

QualityLevel BenchmarkReport::chosen() const {
  std::array<double, kQualities.size()> seconds{};
  for (std::size_t i = 0; i < seconds.size(); ++i) seconds[i] = costs[i].p50Ms / 1000;
  return bestLevel(seconds);
}

std::string toJson(const BenchmarkReport& report) {
  std::string rows;
  for (const FrameCost& cost : report.costs) {
    if (!rows.empty()) rows += ",";
    rows += line(R"({"quality":"%s","p50Ms":%.3f,"p99Ms":%.3f,"allCpuMs":%.3f,"ownCpuMs":%.3f,"drawCalls":%u})", cost);
  }
  return R"({"driver":)" + jsonText(report.driver) + R"(,"default":")" +
         std::string(namedQuality(report.chosen()).name) + R"(","frames":[)" + rows + "]}\n";
}

std::string toText(const BenchmarkReport& report) {
  std::string text = report.driver + ", " + std::to_string(report.frames) + " frames of each quality\n" +
                     "quality   p50 ms   p99 ms   all CPU ms   own CPU ms   draw calls\n";
  for (const FrameCost& cost : report.costs) text += line("%-8s %7.2f  %7.2f  %11.2f  %11.3f  %11u\n", cost);
  return text + "default: " + std::string(namedQuality(report.chosen()).name) + "\n";
}

}  // namespace platon
