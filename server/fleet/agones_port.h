#pragma once

#include <cstdint>
#include <optional>

namespace platon {

/// Environment variable with the TCP port of the sidecar, which Agones sets.
inline constexpr const char* kAgonesPortVariable = "AGONES_SDK_HTTP_PORT";

/// The port in a value of this variable; null or empty: none. Throws ProgramError (kUsage) if it is no port.
std::optional<std::uint16_t> agonesPortOf(const char* value);

}  // namespace platon
