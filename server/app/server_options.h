#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "protocol/limits.h"
#include "server/app/log.h"

namespace platon {

/// Largest value of --max-per-address.
inline constexpr std::uint32_t kMaxPerAddress = 4000;

/// Options of the server, from command line and configuration file.
struct ServerOptions {
  std::vector<std::string> levels;  ///< files; empty: the levels of the game
  std::string bind = "::";
  std::uint16_t port = kDefaultPort;  ///< 0: any free port
  std::uint32_t maxPlayers = 16;      ///< 1 … kMaxPlayers
  std::uint32_t maxPerAddress = 4;    ///< connections of one address; 1 … kMaxPerAddress
  std::string name = "Platon";        ///< a label
  LogFormat logFormat = LogFormat::kText;
  std::string record;  ///< folder for a recording of each round; empty: no recordings

  friend bool operator==(const ServerOptions&, const ServerOptions&) = default;
};

/// Reads the command line and the configuration file that it names. Command-line options override the file. Returns
/// nothing after printing help or version. Throws ProgramError.
std::optional<ServerOptions> readOptions(int argc, const char* const* argv);

}  // namespace platon
