#include "protocol/json_text.h"

#include <cstdint>

namespace platon {

std::string jsonText(std::string_view text) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string json = "\"";
  for (const char byte : text) {
    const auto code = static_cast<std::uint8_t>(byte);
    if (byte == '"' || byte == '\\') {
      json += {'\\', byte};
    } else if (code < 0x20) {
      json += "\\u00";
      json += {digits[code >> 4], digits[code & 15]};
    } else {
      json += byte;
    }
  }
  return json + "\"";
}

}  // namespace platon
