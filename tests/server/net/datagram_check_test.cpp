#include "server/net/datagram_check.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/support/raw_datagram.h"

namespace platon {
namespace {

using Kind = DatagramHead::Kind;

TEST(DatagramCheck, TellsRequestsToConnectFromDatagramsOfPeers) {
  EXPECT_EQ(checkDatagram(connectDatagram(1)).kind, Kind::kConnect);
  const DatagramHead head = checkDatagram(pingDatagram(7));
  EXPECT_EQ(head.kind, Kind::kPeer);
  EXPECT_EQ(head.peer, 7);
}

TEST(DatagramCheck, RejectsDatagramsThatClientsDoNotSend) {
  EXPECT_EQ(checkDatagram(fragmentDatagram(7)).kind, Kind::kInvalid);
  Bytes compressed = pingDatagram(7);
  compressed[0] |= 0x40;
  EXPECT_EQ(checkDatagram(compressed).kind, Kind::kInvalid);
  Bytes pingWithoutPeer = pingDatagram(0xfff);
  EXPECT_EQ(checkDatagram(pingWithoutPeer).kind, Kind::kInvalid);
  Bytes verify = pingDatagram(7);
  verify[kCommandAt] = 0x83;
  EXPECT_EQ(checkDatagram(verify).kind, Kind::kInvalid);
}

TEST(DatagramCheck, RejectsLengthsThatDoNotMatch) {
  for (const Bytes& whole : {connectDatagram(1), pingDatagram(7), unsequencedDatagram(7, 20)}) {
    EXPECT_NE(checkDatagram(whole).kind, Kind::kInvalid);
    for (std::size_t size = 0; size < whole.size(); ++size) {
      EXPECT_EQ(checkDatagram(std::span(whole).first(size)).kind, Kind::kInvalid) << size << " of " << whole.size();
    }
    Bytes longer = whole;
    longer.push_back(1);
    EXPECT_EQ(checkDatagram(longer).kind, Kind::kInvalid);
  }
}

TEST(DatagramCheck, HandlesRandomDatagrams) {
  constexpr std::uint64_t seed = 3;
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937_64 random(seed);
  std::uint64_t passed = 0;
  for (int round = 0; round < 200000; ++round) {
    Bytes bytes = round % 2 == 0 ? unsequencedDatagram(3, 8) : Bytes(random() % 64);
    for (int i = 0; i < 3 && !bytes.empty(); ++i) bytes[random() % bytes.size()] = static_cast<std::uint8_t>(random());
    passed += checkDatagram(bytes).kind == Kind::kPeer ? 1 : 0;
  }
  EXPECT_GT(passed, 0u);
}

}  // namespace
}  // namespace platon
