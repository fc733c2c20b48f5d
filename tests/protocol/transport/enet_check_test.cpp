#include "protocol/transport/enet_check.h"

#include <gtest/gtest.h>

#include <random>

#include "protocol/limits.h"
#include "tests/support/transport/raw_content.h"

namespace platon::enet_check_test {
namespace {

std::optional<EnetCommands> fromClient(ByteSpan content) { return readEnetCommands(content, EnetSender::kClient); }
std::optional<EnetCommands> fromServer(ByteSpan content) { return readEnetCommands(content, EnetSender::kServer); }

Bytes with(Bytes content, std::size_t offset, int value) {
  content[offset] = static_cast<std::uint8_t>(value);
  return content;
}

// The first content, and the commands of the others behind it.
Bytes joined(const std::vector<Bytes>& contents) {
  Bytes all = contents.front();
  for (std::size_t i = 1; i < contents.size(); ++i) {
    all.insert(all.end(), contents[i].begin() + kCommandAt, contents[i].end());
  }
  return all;
}

TEST(EnetCheck, TellsRequestsToConnectFromDatagramsOfPeers) {
  EXPECT_TRUE(fromClient(connectContent(1))->isConnect());
  const std::optional<EnetCommands> ping = fromClient(pingContent(7));
  ASSERT_TRUE(ping);
  EXPECT_FALSE(ping->isConnect());
  EXPECT_EQ(ping->peer, 7);
  EXPECT_EQ(ping->count, 1u);
}

TEST(EnetCheck, TellsARepeatedRequestFromAnother) {
  EXPECT_EQ(fromClient(connectContent(1))->connectId, fromClient(connectContent(1))->connectId);
  EXPECT_NE(fromClient(connectContent(1))->connectId, fromClient(connectContent(2))->connectId);
}

TEST(EnetCheck, ReadsChannelAndSequenceOfEachCommand) {
  const auto commands = fromClient(joined({reliableContent(3, 900, 5), pingContent(3), unsequencedContent(3, 9)}));
  ASSERT_TRUE(commands);
  ASSERT_EQ(commands->count, 3u);
  EXPECT_EQ(commands->commands[0].sequence, 900);
  EXPECT_EQ(commands->commands[0].channel, kReliableChannel);
  EXPECT_EQ(commands->commands[2].channel, kTickChannel);
}

TEST(EnetCheck, RefusesWhatOurProgramsDoNotSend) {
  const Bytes reliable = reliableContent(7, 1, 5);
  EXPECT_TRUE(fromClient(reliable));
  const std::pair<const char*, Bytes> refused[] = {
      {"fragment", fragmentContent(7)},
      {"unreliable without data", unreliableContent(7, 1)},
      {"reliable without data", reliableContent(7, 1, 0)},
      {"unsequenced without data", unsequencedContent(7, 0)},
      {"longest", reliableContent(7, 1, kMaxMessageBytes + 1)},
      {"compressed", with(reliable, 0, reliable[0] | 0x40)},
      {"reliable on the tick channel", with(reliable, kCommandAt + 1, kTickChannel)},
      {"channel that does not exist", with(reliable, kCommandAt + 1, 200)},
      {"reliable without acknowledgement", with(reliable, kCommandAt, ENET_PROTOCOL_COMMAND_SEND_RELIABLE)},
      {"bandwidth limit", with(connectContent(1), kCommandAt, ENET_PROTOCOL_COMMAND_BANDWIDTH_LIMIT | 0x80)},
      {"throttle configuration", with(connectContent(1), kCommandAt, ENET_PROTOCOL_COMMAND_THROTTLE_CONFIGURE | 0x80)},
      {"no command", with(pingContent(7), kCommandAt, 0)},
      {"unknown command", with(pingContent(7), kCommandAt, 15)},
      {"ping without peer", pingContent(0xfff)},
      {"connect to a peer", with(connectContent(1), 1, 7)},
      {"ping beside connect", joined({connectContent(1), pingContent(7)})},
  };
  for (const auto& [what, content] : refused) EXPECT_FALSE(fromClient(content)) << what;
}

TEST(EnetCheck, EachSideMaySendOnlyItsOwnHandshake) {
  EXPECT_TRUE(fromClient(connectContent(1)));
  EXPECT_FALSE(fromServer(connectContent(1)));
  Bytes verify(kCommandAt + enet_protocol_command_size(ENET_PROTOCOL_COMMAND_VERIFY_CONNECT));
  verify[0] = 0x80;
  verify[kCommandAt] = ENET_PROTOCOL_COMMAND_VERIFY_CONNECT | 0x80;
  verify[kCommandAt + 1] = 0xff;
  EXPECT_TRUE(fromServer(verify));
  EXPECT_FALSE(fromClient(verify));
}

TEST(EnetCheck, RefusesTooManyCommands) {
  EXPECT_TRUE(fromClient(joined(std::vector<Bytes>(16, pingContent(7)))));
  EXPECT_FALSE(fromClient(joined(std::vector<Bytes>(17, pingContent(7)))));
  EXPECT_TRUE(fromServer(joined(std::vector<Bytes>(32, pingContent(7)))));
  EXPECT_FALSE(fromServer(joined(std::vector<Bytes>(33, pingContent(7)))));
  EXPECT_TRUE(fromClient(joined(std::vector<Bytes>(32, acknowledgeContent(7, 1)))));
  EXPECT_FALSE(fromClient(joined(std::vector<Bytes>(33, acknowledgeContent(7, 1)))));
}

TEST(EnetCheck, RefusesLengthsThatDoNotMatch) {
  for (const Bytes& whole : {connectContent(1), pingContent(7), unsequencedContent(7, 20), reliableContent(7, 3, 20)}) {
    EXPECT_TRUE(fromClient(whole));
    for (std::size_t size = 0; size < whole.size(); ++size) {
      EXPECT_FALSE(fromClient(ByteSpan(whole).first(size))) << size << " of " << whole.size();
    }
    Bytes longer = whole;
    longer.push_back(1);
    EXPECT_FALSE(fromClient(longer));
  }
}

TEST(EnetCheck, ReliableSequencesMustBeNear) {
  ENetChannel channel{};
  channel.incomingReliableSequenceNumber = 65530;
  ENetPeer peer{};
  peer.channels = &channel;
  peer.channelCount = 1;
  const auto isNear = [&](int sequence) {
    return areSequencesNear(*fromClient(reliableContent(7, static_cast<std::uint16_t>(sequence), 5)), peer);
  };
  EXPECT_TRUE(isNear(65531));
  EXPECT_TRUE(isNear(65530));         // repeated
  EXPECT_TRUE(isNear(65530 - 1000));  // repeated
  EXPECT_TRUE(isNear(65530 + 256));   // after a gap
  EXPECT_FALSE(isNear(65530 + 257));
  EXPECT_FALSE(isNear(65530 + 0x8000));
}

TEST(EnetCheck, AReceiverThatIsClosingIsLeftToEnet) {
  EXPECT_TRUE(areSequencesNear(*fromClient(reliableContent(7, 60000, 5)), ENetPeer{}));
}

TEST(EnetCheck, ReadsRandomContents) {
  constexpr std::uint64_t seed = 3;
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937_64 random(seed);
  std::uint64_t passed = 0;
  for (int round = 0; round < 200000; ++round) {
    Bytes bytes = round % 2 == 0 ? unsequencedContent(3, 8) : Bytes(random() % 64);
    for (int i = 0; i < 3 && !bytes.empty(); ++i) bytes[random() % bytes.size()] = static_cast<std::uint8_t>(random());
    passed += fromClient(bytes) ? 1 : 0;
  }
  EXPECT_GT(passed, 0u);
}

}  // namespace
}  // namespace platon::enet_check_test
