#include "client/play/client_options.h"

#include <CLI/CLI.hpp>

#include <initializer_list>
#include <map>
#include <stdexcept>

#include "client/net/server_link.h"
#include "client/ui/settings.h"
#include "platon_version.h"
#include "protocol/label.h"
#include "protocol/limits.h"
#include "protocol/program_error.h"
#include "protocol/transport/secret_file.h"

namespace platon {

namespace {

void describeFrameOptions(CLI::App& app, FrameOptions& frames) {
  const char* const kGroup = "Moving picture";
  app.add_option("--frames", frames.folder,
                 "Write the frames of a demonstration to this folder; needs --offscreen, --demo and --level")
      ->check(CLI::ExistingDirectory)
      ->option_text("DIR")
      ->group(kGroup);
  app.add_option("--fps", frames.perSecond, "Frames per second of play")
      ->check(CLI::IsMember({1, 2, 3, 4, 5, 6, 10, 12, 15, 20, 30, 60}))
      ->capture_default_str()
      ->group(kGroup);
  app.add_option("--from", frames.from, "Seconds of play before the first frame")
      ->check(CLI::Range(0.0, 300.0))
      ->group(kGroup);
  app.add_option("--width", frames.width, "Pixels; the height is 9/16 of it")
      ->check(CLI::Range(64, 3840))
      ->capture_default_str()
      ->group(kGroup);
  app.add_option("--players", frames.players, "Players; each starts a second after the one before")
      ->check(CLI::Range(1, 4))
      ->capture_default_str()
      ->group(kGroup);
}

void describeEditOptions(CLI::App& app, ClientOptions& options) {
  const char* const kGroup = "Level editor";
  std::map<std::string, SolidKind> solids;
  for (int i = 0; i < kSolidKinds; ++i) {
    const auto kind = static_cast<SolidKind>(i);
    solids.emplace(nameOf(kind), kind);
  }
  app.add_option("--edit", options.edit, "Edit this level file; the first save creates it if it does not exist")
      ->type_name("FILE")
      ->group(kGroup);
  app.add_option("--solid", options.solid, "Solid of a new level; default: HEXAHEDRON")
      ->transform(CLI::CheckedTransformer(solids, CLI::ignore_case))
      ->option_text("TETRAHEDRON|HEXAHEDRON|OCTAHEDRON|DODECAHEDRON|ICOSAHEDRON")
      ->group(kGroup);
}

void describe(CLI::App& app, ClientOptions& options, std::string& host, std::string& passwordFile) {
  app.add_option(
      "HOST", host,
      "Server address, HOST or HOST:PORT, or a link platon://HOST:PORT; without it, --level and --demo: the title");
  app.add_option("--level", options.level,
                 "Level file for the embedded server; default: the levels shipped with Platon")
      ->type_name("FILE");
  app.add_option("--name", options.name, "Your name, as other players see it");
  app.add_option("--password-file", passwordFile, "File with the server's password in its first line")
      ->type_name("FILE");
  app.add_flag("--offscreen", options.offscreen, "Play without a window; needs no display");
  app.add_flag("--demo", options.demo, "Let the program play automatically");
  app.add_option("--seconds", options.seconds, "Exit after this many seconds; default with --offscreen: 10")
      ->check(CLI::Range(0.1, 86400.0));
  app.add_option("--screenshot", options.screenshot, "Write the last frame to this PNG file")->type_name("FILE");
  app.add_flag("--list", options.list, "Print the servers on this machine and in its networks");
  app.add_option(
      "--list-url", options.listUrl,
      "List of servers on a web server, http:// or https://, for --list and for joining in the window, where it "
      "goes before that of the page");
  app.add_flag("--benchmark", options.benchmark, "Measure what a frame costs in each quality; needs --offscreen");
  app.add_flag("--json", options.json, "Print the result of --benchmark as JSON");
  describeFrameOptions(app, options.frames);
  app.add_option("--replay", options.replay, "Watch this recording instead of playing")->type_name("FILE");
  describeEditOptions(app, options);
}

// Refuses `others` beside the option `mode`.
void refuse(const CLI::App& app, const std::string& mode, std::initializer_list<const char*> others) {
  for (const char* const other : others) {
    if (other != mode && app.count(other) > 0)
      throw std::invalid_argument(mode + " does not work with " + other + "; leave one of them out");
  }
}

// Checks `mode`, an option with a file that plays on no server: options of a match are refused.
void checkMode(const CLI::App& app, const std::string& mode, const std::string& file, const ClientOptions& options) {
  if (file.empty() && app.count(mode) > 0) throw std::invalid_argument(mode + " needs the name of a file");
  if (file.empty()) return;
  refuse(app, mode,
         {"HOST", "--level", "--name", "--password-file", "--demo", "--frames", "--fps", "--from", "--width",
          "--players", "--edit", "--replay"});
  if (options.offscreen && options.screenshot.empty())
    throw std::invalid_argument(mode + " with --offscreen needs --screenshot FILE.png");
}

void checkBenchmark(const CLI::App& app, const ClientOptions& options) {
  if (options.json && !options.benchmark) throw std::invalid_argument("--json works only with --benchmark");
  if (!options.benchmark) return;
  if (!options.offscreen) throw std::invalid_argument("--benchmark needs --offscreen");
  refuse(app, "--benchmark",
         {"HOST", "--name", "--password-file", "--demo", "--seconds", "--screenshot", "--frames", "--fps", "--from",
          "--width", "--players", "--edit", "--replay"});
}

void checkList(const CLI::App& app, const ClientOptions& options) {
  if (!options.list) return;
  refuse(app, "--list",
         {"HOST", "--level", "--name", "--password-file", "--offscreen", "--demo", "--seconds", "--screenshot",
          "--benchmark", "--frames", "--fps", "--from", "--width", "--players", "--edit", "--replay"});
}

void checkListUrl(const CLI::App& app, const ClientOptions& options) {
  if (app.count("--list-url") == 0) return;
  if (!isListUrl(options.listUrl)) throw std::invalid_argument(std::string("--list-url must be ") + kListUrlForm);
  refuse(app, "--list-url", {"HOST", "--offscreen", "--demo", "--benchmark", "--frames", "--edit", "--replay"});
}

void checkModes(const CLI::App& app, const ClientOptions& options) {
  checkList(app, options);
  checkListUrl(app, options);
  checkBenchmark(app, options);
  if (options.edit.empty() && app.count("--solid") > 0) throw std::invalid_argument("--solid works only with --edit");
  checkMode(app, "--edit", options.edit, options);
  checkMode(app, "--replay", options.replay, options);
}

void check(ClientOptions& options, const std::string& host) {
  if (!host.empty()) options.server = parseServerAddress(addressOfLink(host));
  if (options.server && !options.level.empty()) {
    throw std::invalid_argument("--level works only with the embedded server; the server at " + options.server->text() +
                                " chooses its own levels");
  }
  if (!options.frames.folder.empty() && !(options.offscreen && options.demo && !options.level.empty())) {
    throw std::invalid_argument("--frames needs --offscreen, --demo and --level FILE");
  }
  if (!isLabel(options.name, kMaxNameBytes)) {
    throw std::invalid_argument("--name must be at most " + std::to_string(kMaxNameBytes) +
                                " bytes of UTF-8 without control characters");
  }
}

}  // namespace

std::optional<ClientOptions> readClientOptions(int argc, const char* const* argv) {
  CLI::App app("Platon: a puzzle platformer on the faces of the Platonic solids.", "platon-client");
  app.set_version_flag("--version", "platon-client " + std::string(kVersion));
  ClientOptions options;
  std::string host;
  std::string passwordFile;
  describe(app, options, host, passwordFile);
  try {
    app.parse(argc, argv);
    checkModes(app, options);
    check(options, host);
    if (!passwordFile.empty()) options.knowledge.password = readPasswordFile(passwordFile);
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
