#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

#include "client/bot/bot_fleet.h"
#include "client/bot/bot_report.h"
#include "client/bot/condition_options.h"
#include "client/time/steady_now.h"
#include "platon_version.h"
#include "protocol/program_error.h"
#include "protocol/transport/secret_file.h"
#include "protocol/transport/server_address.h"

namespace platon {

namespace {

constexpr int kFailed = 1;
constexpr int kUsage = 2;

struct Options {
  std::string host;
  std::string passwordFile;
  FleetOptions fleet;
  bool json = false;
};

void describe(CLI::App& app, Options& options) {
  app.add_option("HOST", options.host, "Server address, HOST or HOST:PORT")->required();
  app.add_option("--count", options.fleet.count, "Number of bots")->required()->check(CLI::Range(1, 256));
  app.add_option("--seconds", options.fleet.seconds, "Duration in seconds")
      ->required()
      ->check(CLI::Range(0.1, 86400.0));
  app.add_option("--seed", options.fleet.seed, "Seed of the buttons and of the simulated network conditions")
      ->capture_default_str();
  app.add_option("--desync-dir", options.fleet.desyncFolder,
                 "Folder for desync reports, created if missing; without it none are written")
      ->type_name("DIR");
  app.add_flag("--hollow", options.fleet.hollow,
               "Bots without a game, to load a server: they join, send inputs and acknowledge ticks; hundreds run on "
               "one machine");
  app.add_option("--settle", options.fleet.settleSeconds,
                 "Seconds after its first tick before a bot is measured; desyncs, resyncs and the largest correction "
                 "are counted from the start")
      ->check(CLI::Range(0.0, 86400.0));
  app.add_option("--password-file", options.passwordFile, "File with the server's password in its first line")
      ->type_name("FILE");
  app.add_flag("--json", options.json, "Print one JSON object");
  addConditionOptions(app, options.fleet.quality);
}

int play(const Options& options) {
  FleetOptions fleet = options.fleet;
  if (!options.passwordFile.empty()) fleet.knowledge.password = readPasswordFile(options.passwordFile);
  const std::vector<BotResult> results = BotFleet(fleet, parseServerAddress(options.host), steadyClock()).play();
  BotReport report = makeReport(results);
  report.hollow = options.fleet.hollow;
  std::fputs((options.json ? toJson(report) : toText(report)).c_str(), stdout);
  const auto failed = std::find_if(results.begin(), results.end(), [](const BotResult& bot) { return bot.ending; });
  if (failed != results.end()) std::fprintf(stderr, "platon-bot: %s\n", failed->ending->c_str());
  return report.failed == 0 ? 0 : kFailed;
}

int run(int argc, char** argv) {
  CLI::App app("Headless clients of Platon that press buttons at random.", "platon-bot");
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
  } catch (const ProgramError& error) {
    std::fprintf(stderr, "platon-bot: %s\n", error.what());
    return error.exitCode();
  } catch (const std::invalid_argument& error) {
    std::fprintf(stderr, "platon-bot: %s\n", error.what());
    return kUsage;
  }
}

}  // namespace

}  // namespace platon

int main(int argc, char** argv) {
  try {
    return platon::run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "platon-bot: %s\n", error.what());
    return platon::kFailed;
  }
}
