#include "protocol/texts.h"

#include <cstdint>

namespace platon {

std::string counted(std::size_t count, std::string_view noun) {
  const char* const ending = count == 1 ? "" : noun.ends_with('s') ? "es" : "s";
  return std::to_string(count) + " " + std::string(noun) + ending;
}

std::string joined(const std::vector<std::string>& parts, std::string_view between) {
  std::string text;
  for (const std::string& part : parts) {
    if (&part != &parts.front()) text += between;
    text += part;
  }
  return text;
}

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
