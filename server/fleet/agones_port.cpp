#include "server/fleet/agones_port.h"

#include <charconv>
#include <string>

#include "protocol/program_error.h"

namespace platon {

std::optional<std::uint16_t> agonesPortOf(const char* value) {
  const std::string_view text = value == nullptr ? "" : value;
  if (text.empty()) return std::nullopt;
  std::uint16_t port = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), port);
  if (error == std::errc() && end == text.data() + text.size() && port != 0) return port;
  throw ProgramError(ProgramError::kUsage, std::string(kAgonesPortVariable) + " must be a port from 1 to 65535, not '" +
                                               std::string(text) + "'; unset it to run without Agones");
}

}  // namespace platon
