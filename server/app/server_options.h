#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "protocol/limits.h"
#include "server/app/log.h"

namespace platon {

/// Connections from one address that may be asked for.
inline constexpr std::uint32_t kMaxPerAddress = 4000;

/// What a server is told by command line and configuration file.
struct ServerOptions {
  std::vector<std::string> levels;  ///< files; none: the shipped rotation
  std::string bind = "0.0.0.0";
  std::uint16_t port = kDefaultPort;  ///< 0: any that is free
  std::uint32_t maxPlayers = 16;      ///< 1 … kMaxPlayers
  std::uint32_t maxPerAddress = 4;    ///< connections from one address; 1 … kMaxPerAddress
  std::string name = "Platon";        ///< a label
  LogFormat logFormat = LogFormat::kText;
  std::string record;  ///< folder for a recording of each round; empty: none

  friend bool operator==(const ServerOptions&, const ServerOptions&) = default;
};

/// Reads the command line, and the configuration file that it names: what both say is taken from the command line.
/// Called again with the same arguments it reads the file anew. Nothing when only help or the version was asked for,
/// which is then on standard output. Throws ProgramError.
std::optional<ServerOptions> readOptions(int argc, const char* const* argv);

}  // namespace platon
