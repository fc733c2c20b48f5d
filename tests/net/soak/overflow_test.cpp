// A connection lives on when its counters overflow: the 14 bits of a sequence number that the seal sends, the 16 bits
// of ENet's packets and the 32 bits of its milliseconds.
#include <gtest/gtest.h>

#include <cstring>

#include "client/net/enet_link.h"
#include "server/net/host.h"
#include "tests/net/support/datagram_network.h"

namespace platon::overflow_test {
namespace {

using std::chrono::milliseconds;

const SocketAddress kServer = addressAt("198.51.100.1", 7777);
const SocketAddress kClient = addressAt("192.0.2.1", 4000);
constexpr Time kOverflow = milliseconds(std::int64_t{1} << 32);
constexpr std::uint32_t kMessages = 70'000;  // of each kind and direction

Bytes messageOf(std::uint32_t number) {
  Bytes bytes(sizeof number);
  std::memcpy(bytes.data(), &number, sizeof number);
  return bytes;
}

std::uint32_t numberOf(ByteSpan bytes) {
  std::uint32_t number = 0;
  std::memcpy(&number, bytes.data(), sizeof number);
  return number;
}

/// Counts messages. The reliable ones are even, and count from 0.
struct Inbox {
  void add(ByteSpan bytes) {
    const std::uint32_t number = numberOf(bytes);
    if (number % 2 == 1) {
      ++unreliable;
    } else {
      misplaced += number / 2 == reliable++ ? 0 : 1;
    }
  }

  void expectAll() const {
    EXPECT_EQ(reliable, kMessages);
    EXPECT_EQ(misplaced, 0u);
    EXPECT_EQ(unreliable, kMessages);
  }

  std::uint32_t reliable = 0;
  std::uint32_t misplaced = 0;
  std::uint32_t unreliable = 0;
};

class OverflowTest : public testing::Test {
 protected:
  void step() {
    now_ += milliseconds(30);  // within the budget of a connection
    for (const HostEvent& event : host_.service(now_)) {
      ASSERT_FALSE(event.disconnected);
      joined_ = event.client;
      host_.admit(event.client);
      atServer_.add(event.bytes);
    }
    client_.service(now_, [this](ByteSpan message) { atClient_.add(message); });
    client_.flush(now_);
    host_.flush(now_);
    network_.forgetSent();
  }

  DatagramNetwork network_;
  Time now_ = kOverflow - std::chrono::seconds(100);
  Host host_{network_.socket(kServer), ServerIdentity::random(), {}, now_};
  EnetLink client_{network_.socket(kClient), {kServer}, {}};
  std::optional<ClientId> joined_;
  Inbox atServer_, atClient_;
};

TEST_F(OverflowTest, EveryMessageArrivesOnceAndInOrder) {
  for (int i = 0; i < 100 && client_.state() != EnetLink::State::kConnected; ++i) step();
  client_.send(messageOf(0), true);
  for (int i = 0; i < 100 && !joined_; ++i) step();
  ASSERT_TRUE(joined_);
  atServer_ = {};
  for (std::uint32_t i = 0; i < kMessages; ++i) {
    for (const bool reliable : {true, false}) {
      client_.send(messageOf(2 * i + (reliable ? 0 : 1)), reliable);
      host_.send(*joined_, reliable, messageOf(2 * i + (reliable ? 0 : 1)));
    }
    step();
  }
  for (int i = 0; i < 100; ++i) step();
  EXPECT_GT(now_, kOverflow);
  atServer_.expectAll();
  atClient_.expectAll();
  EXPECT_EQ(host_.rejections(), Rejections());
}

}  // namespace
}  // namespace platon::overflow_test
