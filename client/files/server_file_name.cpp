#include "client/files/server_file_name.h"

#include <string_view>

namespace platon {

std::string serverFileName(const ServerAddress& server) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string name;
  for (const char c : server.host) {
    const bool plain =
        (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' || c == '-';
    const auto code = static_cast<unsigned char>(c);
    if (plain)
      name += c;
    else
      (name += '%').append({kDigits[code / 16u], kDigits[code % 16u]});
  }
  return name + "_" + std::to_string(server.port);
}

}  // namespace platon
