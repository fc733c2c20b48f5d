#include "client/bot/condition_options.h"

namespace platon {

void addConditionOptions(ProgramOptions& program, LinkQuality& quality) {
  const auto add = [&program](const char* name, double& value, double min, double max, const char* text) {
    return program.add(name, value, text).range(min, max).group("Simulated network conditions, each way");
  };
  const auto percent = [&add](const char* name, double& value, const char* text) {
    return add(name, value, 0, 100, text);
  };
  percent("--loss", quality.lossPercent, "Datagrams lost independently, in per cent");
  auto bursts = percent("--burst-loss", quality.burstLossPercent, "Datagrams lost in bursts, in per cent");
  add("--burst-length", quality.burstLength, 1, 10000, "Mean number of datagrams in a burst; default 4").needs(bursts);
  add("--delay", quality.delayMs, 0, 10000, "Delay in ms");
  add("--jitter", quality.jitterMs, 0, 10000, "Random additional delay, at most this many ms");
  percent("--duplicate", quality.duplicatePercent, "Datagrams delivered twice, in per cent");
  percent("--reorder", quality.reorderPercent, "Datagrams overtaken by later ones, in per cent");
  add("--rate", quality.kilobytesPerSecond, 0, 1e6, "Bandwidth in kilobytes per second; 0: unlimited");
  percent("--corrupt", quality.corruptPercent, "Datagrams with one bit flipped, in per cent");
}

}  // namespace platon
