#include "protocol/transport/server_address.h"

#include <charconv>
#include <stdexcept>

#include "protocol/transport/socket_address.h"

namespace platon {

namespace {

[[noreturn]] void refuseAddress(std::string_view text, const char* why) {
  throw std::invalid_argument("'" + std::string(text) + "' is not a server address: " + why);
}

std::uint16_t parsePort(std::string_view text, std::string_view digits) {
  std::uint16_t port = 0;
  const char* const end = digits.data() + digits.size();
  const auto [rest, error] = std::from_chars(digits.data(), end, port);
  if (error != std::errc() || rest != end || port == 0)
    refuseAddress(text, "the port after ':' must be a number from 1 to 65535");
  return port;
}

// "[ADDRESS]" or "[ADDRESS]:PORT".
ServerAddress parseIpv6(std::string_view text) {
  const std::size_t end = text.find(']');
  ServerAddress address;
  address.host = text.substr(1, end == std::string_view::npos ? end : end - 1);
  if (end == std::string_view::npos || !IpAddress::parse(address.host)) {
    refuseAddress(text, "write an IPv6 address as [ADDRESS] or [ADDRESS]:PORT");
  }
  const std::string_view rest = text.substr(end + 1);
  if (rest.empty()) return address;
  if (rest.front() != ':') refuseAddress(text, "write an IPv6 address as [ADDRESS] or [ADDRESS]:PORT");
  address.port = parsePort(text, rest.substr(1));
  return address;
}

// Such as fe80::1%eth0, in brackets or not.
bool hasZone(std::string_view text) {
  const std::size_t first = text.starts_with('[') ? 1 : 0;
  const std::size_t percent = text.find('%');
  return percent != std::string_view::npos && percent > first &&
         IpAddress::parse(text.substr(first, percent - first)).has_value();
}

bool isHostCharacter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' || c == '-' || c == '_';
}

}  // namespace

std::string ServerAddress::text() const {
  const bool ipv6 = host.find(':') != std::string::npos;
  return (ipv6 ? "[" + host + "]" : host) + ":" + std::to_string(port);
}

ServerAddress parseServerAddress(std::string_view text) {
  if (IpAddress::parse(text)) return {std::string(text), kDefaultPort};
  if (hasZone(text)) {
    refuseAddress(
        text, "an IPv6 address with a zone ('%') is not supported; use the server's name or another of its addresses");
  }
  if (text.starts_with('[')) return parseIpv6(text);
  const std::size_t colon = text.find(':');
  ServerAddress address;
  address.host = text.substr(0, colon);
  if (colon != std::string_view::npos) address.port = parsePort(text, text.substr(colon + 1));
  if (address.host.empty()) refuseAddress(text, "the host is missing; write HOST or HOST:PORT");
  for (const char c : address.host) {
    if (!isHostCharacter(c)) refuseAddress(text, "a host may contain only letters, digits, '.', '-' and '_'");
  }
  return address;
}

bool isNextServer(std::string_view text) {
  if (text.size() > kMaxNextServerBytes) return false;
  try {
    parseServerAddress(text);
    return true;
  } catch (const std::invalid_argument&) {
    return false;
  }
}

}  // namespace platon
