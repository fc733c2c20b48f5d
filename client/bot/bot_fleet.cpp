#include "client/bot/bot_fleet.h"

#include <algorithm>
#include <chrono>
#include <cstdio>

#include "client/bot/bot.h"
#include "client/session/network_client.h"

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

namespace {

constexpr Time kUpdateInterval = std::chrono::milliseconds(2);
constexpr Time kJoinTime = std::chrono::seconds(1);  // in which all bots start to connect

Time fromSeconds(double seconds) { return Time(static_cast<Time::rep>(seconds * 1e6)); }

}  // namespace

std::vector<BotResult> BotFleet::play() {
  const Time start = clock_.now();
  const Time end = start + fromSeconds(options_.seconds);
  const Time spacing = std::min(kJoinTime, (end - start) / 4) / options_.count;
  for (Time now = start; now < end; now = clock_.now()) {
    const auto due = static_cast<std::size_t>(spacing.count() == 0 ? options_.count : (now - start) / spacing + 1);
    while (bots_.size() < std::min(due, static_cast<std::size_t>(options_.count))) add(now);
    update(now);
    clock_.sleepUntil(now + kUpdateInterval);
  }
  std::vector<BotResult> results;
  for (const auto& bot : bots_) results.push_back(bot->result());
  results.resize(static_cast<std::size_t>(options_.count));
  leave();
  return results;
}

void BotFleet::add(Time now) {
  const std::size_t number = bots_.size() + 1;
  bots_.push_back(make("bot " + std::to_string(number), options_.seed * 1000003 + number, now));
}

std::unique_ptr<Bot> BotFleet::make(const std::string& name, std::uint64_t seed, Time now) const {
  const Time settle = fromSeconds(options_.settleSeconds);
  if (options_.hollow)
    return std::make_unique<HollowBot>(server_, name, options_.knowledge, options_.quality, seed, now, settle);
  return std::make_unique<PlayingBot>(server_, name, options_.knowledge, options_.quality, seed, now, settle);
}

void BotFleet::update(Time now) {
  for (std::size_t i = 0; i < bots_.size(); ++i) {
    bots_[i]->update(now);
    const auto desync = bots_[i]->takeDesync();
    if (desync) std::fprintf(stderr, "platon-bot: bot %zu: %s\n", i + 1, desyncFolder_.write(*desync).c_str());
  }
}

void BotFleet::leave() {
  for (const auto& bot : bots_) bot->leave();
  const auto allClosed = [this] {
    return std::all_of(bots_.begin(), bots_.end(), [](const auto& bot) { return bot->closed(); });
  };
  updateUntilClosed(
      clock_, [this](Time now) { update(now); }, allClosed);
}

}  // namespace platon
