#include "client/net/condition_options.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <string>

namespace platon {

namespace {

// CLI::Range would let "nan" pass.
CLI::Validator between(double least, double most) {
  const auto refuse = [least, most](const std::string& text) {
    double value = 0;
    const bool fits = CLI::detail::lexical_cast(text, value) && value >= least && value <= most;
    return fits ? std::string() : fmt::format("'{}' is no number from {} to {}", text, least, most);
  };
  return {refuse, fmt::format("FLOAT in [{} - {}]", least, most)};
}

}  // namespace

void describeConditionOptions(CLI::App& app, LinkQuality& line) {
  const auto add = [&app](const char* name, double& value, const CLI::Validator& range, const char* text) {
    return app.add_option(name, value, text)->check(range)->group(kConditionGroup);
  };
  const CLI::Validator percent = between(0, 100);
  const CLI::Validator milliseconds = between(0, 10000);
  add("--loss", line.lossPercent, percent, "Datagrams lost, per cent each way");
  CLI::Option* const bursts =
      add("--burst-loss", line.burstLossPercent, percent, "Datagrams lost in bursts, per cent each way");
  add("--burst-length", line.burstLength, between(1, 10000), "Datagrams in a burst, on average; 4 unless given")
      ->needs(bursts);
  add("--delay", line.delayMs, milliseconds, "Delay, ms each way");
  add("--jitter", line.jitterMs, milliseconds, "Further delay at random, up to so many ms each way");
  add("--duplicate", line.duplicatePercent, percent, "Datagrams that come twice, per cent each way");
  add("--reorder", line.reorderPercent, percent, "Datagrams that others overtake, per cent each way");
  add("--rate", line.kilobytesPerSecond, between(0, 1e6), "Kilobytes a second that pass, each way; 0: no limit");
  add("--corrupt", line.corruptPercent, percent, "Datagrams of which a bit is flipped, per cent each way");
}

}  // namespace platon
