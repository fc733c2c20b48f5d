#include "client/play/client_options.h"

#include <algorithm>
#include <filesystem>
#include <initializer_list>
#include <map>
#include <stdexcept>

#include "client/ui/settings.h"
#include "protocol/label.h"
#include "protocol/limits.h"
#include "protocol/program_error.h"
#include "protocol/program_options.h"
#include "protocol/transport/server_identity.h"

namespace platon {

namespace {

void describeFrameOptions(ProgramOptions& program, FrameOptions& frames) {
  const char* const kGroup = "Frame sequence";
  program
      .add("--frames", frames.folder,
           "Write the frames of a demonstration to this folder; needs --offscreen, --demo and --level")
      .existingFolder()
      .valueText("DIR")
      .group(kGroup);
  program.add("--fps", frames.perSecond, "Frames per second of play")
      .oneOf({1, 2, 3, 4, 5, 6, 10, 12, 15, 20, 30, 60})
      .showDefault()
      .group(kGroup);
  program.add("--from", frames.from, "Seconds of play before the first frame").range(0.0, 300.0).group(kGroup);
  program.add("--width", frames.width, "Pixels; the height is 9/16 of it").range(64, 3840).showDefault().group(kGroup);
  program.add("--zoom", frames.zoom, "Zoom of the camera").range(0.5, 2.0).showDefault().group(kGroup);
  program.add("--players", frames.players, "Players; each starts a second after the one before")
      .range(1, 4)
      .showDefault()
      .group(kGroup);
}

void describeEditOptions(ProgramOptions& program, ClientOptions& options, int& solid) {
  const char* const kGroup = "Level editor";
  std::map<std::string, int> solids;
  for (int i = 0; i < kSolidKinds; ++i) solids.emplace(nameOf(static_cast<SolidKind>(i)), i);
  program.add("--edit", options.edit, "Edit this level file; the first save creates it if it does not exist")
      .placeholder("FILE")
      .group(kGroup);
  program.addWord("--solid", solid, solids, "Solid of a new level; default: HEXAHEDRON")
      .valueText("TETRAHEDRON|HEXAHEDRON|OCTAHEDRON|DODECAHEDRON|ICOSAHEDRON")
      .group(kGroup);
}

// What the command line says in other words than the options.
struct Words {
  std::string host;
  std::string passwordFile;
  int solid = static_cast<int>(SolidKind::kHexahedron);
};

void describe(ProgramOptions& program, ClientOptions& options, Words& words) {
  program.add("HOST", words.host,
              "Server address, HOST or HOST:PORT, or a link platon://HOST:PORT; without it, --level or --demo, the "
              "title opens");
  program.add("--level", options.level, "Level file for the embedded server; default: the levels shipped with Platon")
      .placeholder("FILE");
  program.add("--name", options.name, "Your name, as other players see it");
  program.add("--password-file", words.passwordFile, "File with the server's password in its first line")
      .placeholder("FILE");
  program.addFlag("--offscreen", options.offscreen, "Play without a window; needs no display");
  program.addFlag("--step", options.step,
                  "Play by commands on standard input, such as 'press d', 'wait 0.5' and 'shot FILE.png'; needs "
                  "--offscreen");
  program.addFlag("--demo", options.demo, "Let the program play automatically");
  program.add("--seconds", options.seconds, "Exit after this many seconds; default with --offscreen: 10")
      .range(0.1, 86400.0);
  program.add("--screenshot", options.screenshot, "Write the last frame to this PNG file").placeholder("FILE");
  program.addFlag("--list", options.list, "Print the servers on this machine and in its networks");
  program.add("--list-url", options.listUrl,
              "URL of a list of servers, http:// or https://, for --list and for joining in the window; overrides the "
              "URL in the settings");
  program.addFlag("--benchmark", options.benchmark, "Measure what a frame costs in each quality; needs --offscreen");
  program.addFlag("--json", options.json, "Print the result of --benchmark as JSON");
  describeFrameOptions(program, options.frames);
  program.add("--replay", options.replay, "Watch this recording instead of playing").placeholder("FILE");
  describeEditOptions(program, options, words.solid);
}

// Refuses `others` beside the option `mode`.
void refuse(const ProgramOptions& program, const std::string& mode, std::initializer_list<const char*> others) {
  for (const char* const other : others) {
    if (other != mode && program.given(other))
      throw std::invalid_argument(mode + " does not work with " + other + "; leave one of them out");
  }
}

// Checks `mode`, an option with a file that plays on no server: options of a match are refused.
void checkMode(const ProgramOptions& program, const std::string& mode, const std::string& file,
               const ClientOptions& options) {
  if (file.empty() && program.given(mode)) throw std::invalid_argument(mode + " needs the name of a file");
  if (file.empty()) return;
  refuse(program, mode,
         {"HOST", "--level", "--name", "--password-file", "--demo", "--frames", "--fps", "--from", "--width", "--zoom",
          "--players", "--edit", "--replay", "--step"});
  if (options.offscreen && options.screenshot.empty())
    throw std::invalid_argument(mode + " with --offscreen needs --screenshot FILE.png");
}

void checkBenchmark(const ProgramOptions& program, const ClientOptions& options) {
  if (options.json && !options.benchmark) throw std::invalid_argument("--json works only with --benchmark");
  if (!options.benchmark) return;
  if (!options.offscreen) throw std::invalid_argument("--benchmark needs --offscreen");
  refuse(program, "--benchmark",
         {"HOST", "--name", "--password-file", "--demo", "--seconds", "--screenshot", "--frames", "--fps", "--from",
          "--width", "--zoom", "--players", "--edit", "--replay", "--step"});
}

// A server elsewhere does not wait for the commands.
void checkStep(const ProgramOptions& program, const ClientOptions& options) {
  if (!options.step) return;
  if (!options.offscreen) throw std::invalid_argument("--step needs --offscreen");
  refuse(program, "--step", {"HOST", "--password-file", "--seconds", "--screenshot", "--frames", "--list-url"});
}

void checkList(const ProgramOptions& program, const ClientOptions& options) {
  if (!options.list) return;
  refuse(
      program, "--list",
      {"HOST", "--level", "--name", "--password-file", "--offscreen", "--demo", "--seconds", "--screenshot",
       "--benchmark", "--frames", "--fps", "--from", "--width", "--zoom", "--players", "--edit", "--replay", "--step"});
}

void checkListUrl(const ProgramOptions& program, const ClientOptions& options) {
  if (!program.given("--list-url")) return;
  if (!isListUrl(options.listUrl)) throw std::invalid_argument(std::string("--list-url must be ") + kListUrlForm);
  refuse(program, "--list-url", {"HOST", "--offscreen", "--demo", "--benchmark", "--frames", "--edit", "--replay"});
}

void checkModes(const ProgramOptions& program, const ClientOptions& options) {
  checkList(program, options);
  checkListUrl(program, options);
  checkBenchmark(program, options);
  checkStep(program, options);
  if (options.edit.empty() && program.given("--solid")) throw std::invalid_argument("--solid works only with --edit");
  checkMode(program, "--edit", options.edit, options);
  checkMode(program, "--replay", options.replay, options);
}

constexpr std::string_view kScheme = "platon://";

// Schemes may be written in capitals, too.
bool beginsWithScheme(std::string_view text) {
  const auto same = [](char own, char other) {
    return own == (other >= 'A' && other <= 'Z' ? other - 'A' + 'a' : other);
  };
  return text.size() >= kScheme.size() && std::equal(kScheme.begin(), kScheme.end(), text.begin(), same);
}

// Programs that play files take their names without an option, so a player may name one where the server stands.
void refuseFile(const std::string& host) {
  const std::filesystem::path file(host);
  const bool looksLikeFile = file.has_parent_path() || file.extension() == ".level" || file.extension() == ".recording";
  std::error_code ignored;  // then it is no file
  if (!looksLikeFile || !std::filesystem::is_regular_file(file, ignored)) return;
  throw std::invalid_argument(
      "'" + host +
      "' is a file, but a server is expected here; put --level before a level to play it, --edit "
      "to edit it, or --replay before a recording to watch it");
}

void check(ClientOptions& options, const std::string& host) {
  refuseFile(host);
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

std::string_view addressOfLink(std::string_view text) {
  if (!beginsWithScheme(text)) return text;
  text.remove_prefix(kScheme.size());
  if (text.ends_with('/')) text.remove_suffix(1);
  return text;
}

std::optional<ClientOptions> readClientOptions(int argc, const char* const* argv) {
  ProgramOptions program("platon-client", "Platon: a puzzle platformer on the faces of the Platonic solids.");
  ClientOptions options;
  Words words;
  describe(program, options, words);
  if (!program.read(argc, argv)) return std::nullopt;
  try {
    checkModes(program, options);
    check(options, words.host);
    if (!words.passwordFile.empty()) options.knowledge.password = readPasswordFile(words.passwordFile);
    options.solid = static_cast<SolidKind>(words.solid);
    return options;
  } catch (const std::invalid_argument& error) {
    throw ProgramError(ProgramError::kUsage, error.what());
  }
}

}  // namespace platon
