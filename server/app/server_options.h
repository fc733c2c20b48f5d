#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "protocol/limits.h"
#include "protocol/program_error.h"
#include "server/app/log.h"

namespace platon {

/// Options of the server, from command line and configuration file. server/program/options.h describes each.
struct ServerOptions {
  std::vector<std::string> levels;  ///< files; empty: the levels of the game
  std::string bind = "::";
  std::uint16_t port = kDefaultPort;  ///< 0: any free port
  std::uint32_t maxPlayers = 16;
  std::uint32_t maxPerAddress = 4;  ///< players of one address
  std::string name = "Platon";      ///< a label
  LogFormat logFormat = LogFormat::kText;
  std::string record;               ///< folder for a recording of each round; empty: no recordings
  std::string banFile;              ///< empty: bans end with the server
  std::string socket;               ///< of the console; empty: `defaultConsolePath`
  std::string metrics;              ///< as `parseSocketAddress` reads it; empty: no metrics
  std::string keyFile{};            ///< empty: `defaultKeyFile`
  std::string passwordFile{};       ///< empty: no password
  std::string recordLimit = "10G";  ///< of all recordings in the folder, as `parseByteSize` reads it
  std::string bestTimes{};          ///< file; empty: best times end with the server
  std::string chat = "on";          ///< or "off"
  std::uint32_t drain = 0;          ///< longest time to drain at SIGTERM, seconds; 0: stops at once
  std::string drainTo{};            ///< address of the server where players go on; empty: none
  std::string announce{};           ///< file: list of servers with this one; empty: none
  std::string announceAs{};         ///< address in this list, where players join; not empty if `announce` is not

  friend bool operator==(const ServerOptions&, const ServerOptions&) = default;
};

/// What the program ends with if its configuration or its files have these errors, of which there is at least one: the
/// first in one line, and how many more there are.
inline ProgramError usageError(const std::vector<std::string>& errors) {
  const std::size_t more = errors.size() - 1;
  return {ProgramError::kUsage,
          more == 0 ? errors.front()
                    : errors.front() + " (and " + std::to_string(more) + " more: --check-config lists all)"};
}

}  // namespace platon
