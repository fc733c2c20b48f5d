#include "client/bot/condition_options.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <string>

namespace platon {

namespace {

// Unlike CLI::Range, refuses "nan".
CLI::Validator between(double min, double max) {
  const auto refuse = [min, max](const std::string& text) {
    double value = 0;
    const bool valid = CLI::detail::lexical_cast(text, value) && value >= min && value <= max;
    return valid ? std::string() : fmt::format("'{}' is not a number from {} to {}", text, min, max);
  };
  return {refuse, fmt::format("FLOAT in [{} - {}]", min, max)};
}

}  // namespace

void addConditionOptions(CLI::App& app, LinkQuality& quality) {
  const auto add = [&app](const char* name, double& value, const CLI::Validator& range, const char* text) {
    return app.add_option(name, value, text)->check(range)->group("Simulated network conditions, each way");
  };
  const CLI::Validator percent = between(0, 100);
  const CLI::Validator milliseconds = between(0, 10000);
  add("--loss", quality.lossPercent, percent, "Datagrams lost independently, in per cent");
  CLI::Option* const bursts =
      add("--burst-loss", quality.burstLossPercent, percent, "Datagrams lost in bursts, in per cent");
  add("--burst-length", quality.burstLength, between(1, 10000), "Mean number of datagrams in a burst; default 4")
      ->needs(bursts);
  add("--delay", quality.delayMs, milliseconds, "Delay in ms");
  add("--jitter", quality.jitterMs, milliseconds, "Random additional delay, at most this many ms");
  add("--duplicate", quality.duplicatePercent, percent, "Datagrams delivered twice, in per cent");
  add("--reorder", quality.reorderPercent, percent, "Datagrams overtaken by later ones, in per cent");
  add("--rate", quality.kilobytesPerSecond, between(0, 1e6), "Bandwidth in kilobytes per second; 0: unlimited");
  add("--corrupt", quality.corruptPercent, percent, "Datagrams with one bit flipped, in per cent");
}

}  // namespace platon
