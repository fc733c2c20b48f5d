#include "client/play/client_options.h"

#include <CLI/CLI.hpp>

#include <stdexcept>

#include "client/net/condition_options.h"
#include "platon_version.h"
#include "protocol/label.h"
#include "protocol/limits.h"
#include "protocol/program_error.h"

namespace platon {

namespace {

void describe(CLI::App& app, ClientOptions& options, std::string& host) {
  app.add_option("HOST", host, "Server to play on, HOST or HOST:PORT; without one a server of your own is started");
  app.add_option("--level", options.level,
                 "Level file for the server of your own; else the levels that come with Platon");
  app.add_option("--name", options.name, "How others see you");
  app.add_flag("--offscreen", options.offscreen, "Play without a window; needs no display");
  app.add_flag("--demo", options.demo, "Let the program find the way to the goal by itself");
  app.add_option("--seconds", options.seconds, "End after so many seconds; off-screen 10 unless given")
      ->check(CLI::Range(0.1, 86400.0));
  app.add_option("--screenshot", options.screenshot, "Write the last picture to this PNG file");
  describeConditionOptions(app, options.line);
  app.add_option("--line-seed", options.lineSeed, "The same seed gives the same draws")
      ->capture_default_str()
      ->group(kConditionGroup);
}

void check(ClientOptions& options, const std::string& host) {
  if (!host.empty()) options.server = parseServerAddress(host);
  if (options.server && !options.level.empty()) {
    throw std::invalid_argument("--level is for a server of your own; the server at " + options.server->text() +
                                " chooses its levels itself");
  }
  if (!isLabel(options.name, kMaxNameBytes)) {
    throw std::invalid_argument("--name takes at most " + std::to_string(kMaxNameBytes) +
                                " bytes of UTF-8 without control characters");
  }
}

}  // namespace

std::optional<ClientOptions> readClientOptions(int argc, const char* const* argv) {
  CLI::App app("Platon: a puzzle platformer on the faces of the Platonic solids.", "platon-client");
  app.set_version_flag("--version", "platon-client " + std::string(kVersion));
  ClientOptions options;
  std::string host;
  describe(app, options, host);
  try {
    app.parse(argc, argv);
    check(options, host);
    return options;
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0) {
      throw ProgramError(ProgramError::kUsage, std::string(error.what()) + " (see platon-client --help)");
    }
    app.exit(error);
    return std::nullopt;
  } catch (const std::invalid_argument& error) {
    throw ProgramError(ProgramError::kUsage, error.what());
  }
}

}  // namespace platon
