#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "platon/game/solid.h"
#include "protocol/transport/client_gate.h"
#include "protocol/transport/server_address.h"

namespace platon {

/// Options for writing the frames of a game that the demonstration plays without server, window or clock.
struct FrameOptions {
  std::string folder;          ///< for 0000.png, 0001.png …; empty: no frames
  int perSecond = 30;          ///< divides kTicksPerSecond
  double from = 0;             ///< seconds of play before the first frame
  std::uint32_t width = 1280;  ///< pixels; the height is 9/16 of it
  double zoom = 1;             ///< of the camera, 0.5 … 2
  std::uint32_t players = 1;   ///< each starts a second after the one before; the camera follows the first
};

/// Command-line options of `platon-client`.
struct ClientOptions {
  std::optional<ServerAddress> server;  ///< empty: start an embedded server
  std::string level;                    ///< level file for the embedded server; empty: the shipped levels
  std::string name;                     ///< a valid label; empty: the server chooses a name
  ServerKnowledge knowledge{};          ///< of the server; the password from --password-file
  bool offscreen = false;
  bool step = false;  ///< play by commands, in steps
  bool demo = false;
  std::optional<double> seconds;  ///< maximum duration
  std::string screenshot;         ///< PNG file for the last frame; empty: none
  bool list = false;              ///< print the servers nearby instead of playing
  std::string listUrl;            ///< list of servers on a web server; empty: none
  bool benchmark = false;         ///< measure frames instead of playing
  bool json = false;              ///< the result of the benchmark as JSON
  FrameOptions frames;
  std::string replay;                        ///< recording to watch; empty: play
  std::string edit;                          ///< level file for the editor; empty: play
  SolidKind solid = SolidKind::kHexahedron;  ///< of a new level of the editor
};

/// The address in a link to a server, `platon://HOST[:PORT]`, with or without a slash at its end, as a browser hands it
/// to the program. A text that is no such link is returned as it is. The result need not be a valid address:
/// parseServerAddress refuses what is not one. It is a part of `text`.
std::string_view addressOfLink(std::string_view text);

/// Parses the command line. Returns nothing after printing the help or the version. Throws ProgramError.
std::optional<ClientOptions> readClientOptions(int argc, const char* const* argv);

}  // namespace platon
