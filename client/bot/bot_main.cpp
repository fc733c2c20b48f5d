#include <algorithm>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

#include "client/bot/bot_fleet.h"
#include "client/bot/bot_report.h"
#include "client/time/steady_now.h"
#include "protocol/program_error.h"
#include "protocol/program_options.h"
#include "protocol/transport/server_address.h"
#include "protocol/transport/server_identity.h"

namespace platon {

namespace {

struct Options {
  std::string host;
  std::string passwordFile;
  FleetOptions fleet;
  bool json = false;
};

void describe(ProgramOptions& program, Options& options) {
  program.add("HOST", options.host, "Server address, HOST or HOST:PORT").required();
  program.add("--count", options.fleet.count, "Number of bots").required().range(1, 256);
  program.add("--seconds", options.fleet.seconds, "Duration in seconds").required().range(0.1, 86400.0);
  program.add("--seed", options.fleet.seed, "Seed of the buttons and of the simulated network conditions")
      .showDefault();
  program
      .add("--desync-dir", options.fleet.desyncFolder,
           "Folder for desync reports, created if missing; without it none are written")
      .placeholder("DIR");
  program.addFlag("--hollow", options.fleet.hollow,
                  "Bots without a game, to load a server: they join, send inputs and acknowledge ticks; hundreds run "
                  "on one machine");
  program
      .add("--settle", options.fleet.settleSeconds,
           "Seconds after its first tick before a bot is measured; desyncs, resyncs and the largest correction are "
           "counted from the start")
      .range(0.0, 86400.0);
  program.add("--password-file", options.passwordFile, "File with the server's password in its first line")
      .placeholder("FILE");
  program.addFlag("--json", options.json, "Print one JSON object");
  addConditionOptions(program, options.fleet.quality);
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
  return report.failed == 0 ? 0 : ProgramError::kFailed;
}

int run(int argc, char** argv) {
  ProgramOptions program("platon-bot", "Headless clients of Platon that press buttons at random.");
  Options options;
  describe(program, options);
  try {
    return program.read(argc, argv) ? play(options) : 0;
  } catch (const ProgramError& error) {
    std::fprintf(stderr, "platon-bot: %s\n", error.what());
    return error.exitCode();
  } catch (const std::invalid_argument& error) {
    std::fprintf(stderr, "platon-bot: %s\n", error.what());
    return ProgramError::kUsage;
  }
}

}  // namespace

}  // namespace platon

int main(int argc, char** argv) {
  try {
    return platon::run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "platon-bot: %s\n", error.what());
    return platon::ProgramError::kFailed;
  }
}
