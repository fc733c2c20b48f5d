#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "client/net/network_conditions.h"
#include "client/net/server_address.h"
#include "client/play/frame_options.h"

namespace platon {

/// What `platon-client` is told.
struct ClientOptions {
  std::optional<ServerAddress> server;  ///< none: an embedded one
  std::string level;                    ///< file for the embedded server; empty: the shipped rotation
  std::string name;                     ///< a label; empty: the server makes one up
  bool offscreen = false;
  bool demo = false;
  std::optional<double> seconds;  ///< to play at most
  std::string screenshot;         ///< file for the last picture; empty: none
  FrameOptions frames;
  LinkQuality line;            ///< simulated on the way to the server, each way
  std::uint64_t lineSeed = 1;  ///< of its draws
};

/// Reads the command line. Nothing when only help or the version was asked for, which is then on standard output.
/// Throws ProgramError.
std::optional<ClientOptions> readClientOptions(int argc, const char* const* argv);

}  // namespace platon
