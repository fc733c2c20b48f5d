#include "server/admin/origin_address.h"

#include <cstring>

namespace platon {

std::optional<IpAddress> addressOfOrigin(std::uint32_t origin) {
  if (origin == 0) return std::nullopt;
  IpAddress address;
  address.bytes[10] = address.bytes[11] = 0xff;
  std::memcpy(&address.bytes[12], &origin, sizeof origin);
  return address;
}

}  // namespace platon
