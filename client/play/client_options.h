#pragma once

#include <optional>
#include <string>

#include "client/play/offscreen/frame_options.h"
#include "platon/game/solid.h"
#include "protocol/transport/client_gate.h"
#include "protocol/transport/server_address.h"

namespace platon {

/// Command-line options of `platon-client`.
struct ClientOptions {
  std::optional<ServerAddress> server;  ///< empty: start an embedded server
  std::string level;                    ///< level file for the embedded server; empty: the shipped levels
  std::string name;                     ///< a valid label; empty: the server chooses a name
  ServerKnowledge knowledge{};          ///< of the server; the password from --password-file
  bool offscreen = false;
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

/// Parses the command line. Returns nothing after printing the help or the version. Throws ProgramError.
std::optional<ClientOptions> readClientOptions(int argc, const char* const* argv);

}  // namespace platon
