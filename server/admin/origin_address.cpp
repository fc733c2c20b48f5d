#include "server/admin/origin_address.h"

namespace platon {

std::optional<IpAddress> addressOfOrigin(std::uint64_t origin) {
  if (origin == 0) return std::nullopt;
  constexpr std::uint64_t kIpv4Prefix = 0xffff;
  IpAddress address;
  const std::size_t first = origin >> 32 == kIpv4Prefix ? address.bytes.size() - sizeof origin : 0;
  for (std::size_t i = 0; i < sizeof origin; ++i) {
    address.bytes[first + i] = static_cast<std::uint8_t>(origin >> (8 * (sizeof origin - 1 - i)));
  }
  return address;
}

}  // namespace platon
