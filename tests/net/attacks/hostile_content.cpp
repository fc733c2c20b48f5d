#include "tests/net/attacks/hostile_content.h"

#include <enet/enet.h>

namespace platon {
namespace {

constexpr std::size_t kChannelAt = kCommandAt + 1;

}  // namespace

Bytes unreliableFragmentContent(std::uint16_t peer) {
  Bytes content = fragmentContent(peer);
  content[kCommandAt] = ENET_PROTOCOL_COMMAND_SEND_UNRELIABLE_FRAGMENT;
  content[kChannelAt] = 1;
  return content;
}

Bytes crowdedContent(std::uint16_t peer) {
  Bytes content = pingContent(peer);
  const Bytes ping(content.begin() + kCommandAt, content.end());
  for (int i = 1; i < 100; ++i) content.insert(content.end(), ping.begin(), ping.end());
  return content;
}

Bytes hostileContent(std::uint16_t peer, std::uint32_t number) {
  const auto sequence = static_cast<std::uint16_t>(number * 40503);
  switch (number % kHostileContents) {
    case 0:
      return connectContent(number);
    case 1:
      return unreliableContent(peer, sequence);
    case 2:
      return unreliableContent(peer, static_cast<std::uint16_t>(60000 + number % 5000));
    case 3:
      return fragmentContent(peer);
    case 4:
      return unreliableFragmentContent(peer);
    case 5:
      return reliableContent(peer, static_cast<std::uint16_t>(2000 + number % 30000), 5);
    case 6:
      return reliableContent(peer, 1, 0);
    case 7:
      return reliableContent(peer, static_cast<std::uint16_t>(100 + number % 150), 1000);  // a gap that is never filled
    case 8:
      return crowdedContent(peer);
    case 9:
      return acknowledgeContent(peer, sequence);
    case 10:
      return pingContent(static_cast<std::uint16_t>(number % 80));
    case 11:
      return disconnectContent(static_cast<std::uint16_t>((peer + 1) % 80));
    case 12:
      return unsequencedContent(peer, 0);
    case 13:
      return unsequencedContent(peer, 1160);
    case 14:
      return Bytes(30, 0xff);
    default:
      return Bytes{0};
  }
}

}  // namespace platon
