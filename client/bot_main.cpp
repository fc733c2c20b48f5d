#include <CLI/CLI.hpp>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "client/bot.h"
#include "client/bot_report.h"
#include "client/server_address.h"
#include "client/steady_now.h"
#include "platon_version.h"

namespace platon {

namespace {

constexpr int kFailed = 1;
constexpr int kUsage = 2;
constexpr Moment kBeat = std::chrono::milliseconds(2);
constexpr Moment kArrivals = std::chrono::seconds(1);       // in which all bots come, one after another
constexpr Moment kFarewell = std::chrono::milliseconds(500);

struct Options {
  std::string host;
  int count = 1;
  double seconds = 10;
  std::uint64_t seed = 1;
  LinkQuality line;
  bool json = false;
};

void describe(CLI::App& app, Options& options) {
  app.add_option("HOST", options.host, "The server, HOST or HOST:PORT")->required();
  app.add_option("--count", options.count, "How many bots")->required()->check(CLI::Range(1, 256));
  app.add_option("--seconds", options.seconds, "How long they play")->required()->check(CLI::Range(0.1, 86400.0));
  app.add_option("--seed", options.seed, "Of the buttons and of the line; the same seed gives the same")
      ->capture_default_str();
  const CLI::Range percent(0.0, 100.0);
  const CLI::Range milliseconds(0.0, 10000.0);
  app.add_option("--loss", options.line.lossPercent, "Datagrams lost, per cent each way")->check(percent);
  app.add_option("--delay", options.line.delayMs, "Delay, ms each way")->check(milliseconds);
  app.add_option("--jitter", options.line.jitterMs, "Further delay at random, up to so many ms each way")
      ->check(milliseconds);
  app.add_option("--duplicate", options.line.duplicatePercent, "Datagrams that come twice, per cent each way")
      ->check(percent);
  app.add_option("--reorder", options.line.reorderPercent, "Datagrams that others overtake, per cent each way")
      ->check(percent);
  app.add_flag("--json", options.json, "Print one JSON object");
}

class Fleet {
 public:
  Fleet(const Options& options, const ServerAddress& server) : options_(&options), server_(server) {}

  void play() {
    const Moment start = steadyNow();
    const Moment end = start + Moment(static_cast<Moment::rep>(options_->seconds * 1e6));
    const Moment spacing = std::min(kArrivals, (end - start) / 4) / options_->count;
    for (Moment now = start; now < end; now = beat()) {
      while (bots_.size() < static_cast<std::size_t>(options_->count) &&
             now >= start + spacing * static_cast<Moment::rep>(bots_.size())) {
        add(now);
      }
    }
  }

  std::vector<BotResult> results() const {
    std::vector<BotResult> results;
    for (const auto& bot : bots_) results.push_back(bot->result());
    results.resize(static_cast<std::size_t>(options_->count));
    return results;
  }

  void leave() {
    for (const auto& bot : bots_) bot->leave();
    const Moment end = steadyNow() + kFarewell;
    const auto closed = [](const auto& bot) { return bot->closed(); };
    for (Moment now = steadyNow(); now < end && !std::all_of(bots_.begin(), bots_.end(), closed);) now = beat();
  }

 private:
  void add(Moment now) {
    const std::size_t number = bots_.size() + 1;
    bots_.push_back(std::make_unique<Bot>(server_, "bot " + std::to_string(number), options_->line,
                                          options_->seed * 1000003 + number, now));
  }

  Moment beat() {
    const Moment now = steadyNow();
    for (const auto& bot : bots_) bot->update(now);
    std::this_thread::sleep_until(std::chrono::steady_clock::time_point(now + kBeat));
    return steadyNow();
  }

  const Options* options_;
  ServerAddress server_;
  std::vector<std::unique_ptr<Bot>> bots_;
};

int play(const Options& options) {
  Fleet fleet(options, parseServerAddress(options.host));
  fleet.play();
  const std::vector<BotResult> results = fleet.results();
  fleet.leave();
  const BotReport report = makeReport(results);
  std::fputs((options.json ? toJson(report) : toText(report)).c_str(), stdout);
  const auto fallen = std::find_if(results.begin(), results.end(), [](const BotResult& bot) { return bot.ending; });
  if (fallen != results.end()) std::fprintf(stderr, "platon-bot: %s\n", fallen->ending->c_str());
  return report.failed == 0 ? 0 : kFailed;
}

int run(int argc, char** argv) {
  CLI::App app("Headless clients of Platon that press buttons at random, on simulated lines.", "platon-bot");
  app.set_version_flag("--version", "platon-bot " + std::string(kVersion));
  Options options;
  describe(app, options);
  try {
    app.parse(argc, argv);
    return play(options);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    std::fprintf(stderr, "platon-bot: %s (see platon-bot --help)\n", error.what());
    return kUsage;
  } catch (const std::invalid_argument& error) {
    std::fprintf(stderr, "platon-bot: %s\n", error.what());
    return kUsage;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "platon-bot: %s\n", error.what());
    return kFailed;
  }
}

}  // namespace

}  // namespace platon

int main(int argc, char** argv) { return platon::run(argc, argv); }
