#include "client/bot/bot_fleet.h"

#include <algorithm>
#include <chrono>
#include <cstdio>

#include "client/bot/hollow_bot.h"

namespace platon {

namespace {

constexpr Moment kBeat = std::chrono::milliseconds(2);
constexpr Moment kArrivals = std::chrono::seconds(1);  // in which all bots come
constexpr Moment kFarewell = std::chrono::milliseconds(500);

Moment duration(double seconds) { return Moment(static_cast<Moment::rep>(seconds * 1e6)); }

}  // namespace

std::vector<BotResult> BotFleet::play() {
  const Moment start = clock_.now();
  const Moment end = start + duration(options_.seconds);
  const Moment spacing = std::min(kArrivals, (end - start) / 4) / options_.count;
  for (Moment now = start; now < end; now = clock_.now()) {
    const auto arrived = static_cast<std::size_t>(spacing.count() == 0 ? options_.count : (now - start) / spacing + 1);
    while (bots_.size() < std::min(arrived, static_cast<std::size_t>(options_.count))) add(now);
    beat(now);
  }
  std::vector<BotResult> results;
  for (const auto& bot : bots_) results.push_back(bot->result());
  results.resize(static_cast<std::size_t>(options_.count));
  leave();
  return results;
}

void BotFleet::add(Moment now) {
  const std::size_t number = bots_.size() + 1;
  bots_.push_back(make("bot " + std::to_string(number), options_.seed * 1000003 + number, now));
}

std::unique_ptr<Bot> BotFleet::make(const std::string& name, std::uint64_t seed, Moment now) const {
  const Moment settle = duration(options_.settleSeconds);
  if (options_.hollow) return std::make_unique<HollowBot>(server_, name, options_.line, seed, now, settle);
  return std::make_unique<PlayingBot>(server_, name, options_.line, seed, now, settle);
}

void BotFleet::beat(Moment now) {
  for (std::size_t i = 0; i < bots_.size(); ++i) {
    bots_[i]->update(now);
    const auto desync = bots_[i]->takeDesync();
    if (!desync) continue;
    std::fprintf(stderr, "platon-bot: bot %zu: %s\n", i + 1, desyncs_.keep(*desync).c_str());
  }
  clock_.sleepUntil(now + kBeat);
}

void BotFleet::leave() {
  for (const auto& bot : bots_) bot->leave();
  const auto closed = [](const auto& bot) { return bot->closed(); };
  const Moment end = clock_.now() + kFarewell;
  for (Moment now = clock_.now(); now < end; now = clock_.now()) {
    beat(now);
    if (std::all_of(bots_.begin(), bots_.end(), closed)) return;
  }
}

}  // namespace platon
