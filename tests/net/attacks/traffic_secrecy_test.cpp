#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string_view>

#include "client/net/enet_link.h"
#include "protocol/to_client.h"
#include "protocol/to_server.h"
#include "server/net/host.h"
#include "tests/net/support/datagram_network.h"

namespace platon::traffic_secrecy_test {
namespace {

using std::chrono::milliseconds;

const SocketAddress kServer = addressAt("198.51.100.1", 7777);
const SocketAddress kClient = addressAt("192.0.2.1", 4000);
constexpr std::string_view kName = "Rumpelstilzchen";
constexpr std::size_t kReadable = 6;  // so many bytes in a row are no chance
constexpr std::size_t kHead = 4;      // at most, of a sealed datagram: its number and slot are no secret

Bytes bytesOf(std::string_view text) { return {text.begin(), text.end()}; }

/// A client that says what must stay secret, a server that answers with it, and all that passed between them.
class TrafficSecrecyTest : public testing::Test {
 protected:
  void step() {
    now_ += milliseconds(5);
    for (const HostEvent& event : host_.service(now_)) {
      if (!event.disconnected) answer(event);
    }
    host_.flush(now_);
    client_.service(now_, [this](std::span<const std::uint8_t>) { ++received_; });
    client_.flush(now_);
  }

  void answer(const HostEvent& event) {
    host_.admit(event.client);
    heard_.emplace_back(event.bytes.begin(), event.bytes.end());
    host_.send(event.client, true, encode(Roster{{{0, std::string(kName)}}}));
  }

  void connect() {
    for (int i = 0; i < 1000 && client_.state() != EnetLink::State::kConnected; ++i) step();
    ASSERT_EQ(client_.state(), EnetLink::State::kConnected);
  }

  void say(const Bytes& message, bool reliable) {
    client_.send(message, reliable);
    client_.flush(now_);
    step();
  }

  // Whether a part of `secret` stands in any datagram of either direction, outside the heads.
  bool isReadable(const Bytes& secret) const {
    for (std::size_t at = 0; at + kReadable <= secret.size(); ++at) {
      const auto begin = secret.begin() + static_cast<std::ptrdiff_t>(at);
      for (const DatagramNetwork::Sent& sent : network_.sent()) {
        const ByteSpan readable = ByteSpan{sent.bytes}.subspan(SealedChannel::isSealed(sent.bytes) ? kHead : 0);
        const auto found = std::search(readable.begin(), readable.end(), begin, begin + kReadable);
        if (found != readable.end()) return true;
      }
    }
    return false;
  }

  // The datagrams of the client after the handshake.
  std::vector<Bytes> sealedByClient() const {
    std::vector<Bytes> sealed;
    for (const DatagramNetwork::Sent& sent : network_.sent()) {
      if (sent.from == kClient && SealedChannel::isSealed(sent.bytes)) sealed.push_back(sent.bytes);
    }
    return sealed;
  }

  DatagramNetwork network_;
  Time now_ = std::chrono::seconds(1000);
  Host host_{network_.socket(kServer), ServerIdentity::random(), {}, now_};
  EnetLink client_{network_.socket(kClient), {kServer}, {}};
  std::vector<Bytes> heard_;
  int received_ = 0;
};

PlayerInputs someInputs() {
  PlayerInputs inputs;
  inputs.round = 300;
  inputs.confirmed = 70000;
  inputs.first = 70001;
  inputs.hash = 0x89abcdef;
  for (int i = 0; i < 40; ++i) inputs.inputs.push_back(Input{static_cast<std::uint8_t>(Input::kPresent | (i % 3))});
  return inputs;
}

TEST_F(TrafficSecrecyTest, NoNameTokenOrInputIsReadable) {
  connect();
  Hello hello;
  hello.name = kName;
  hello.token.emplace();
  for (std::size_t i = 0; i < hello.token->size(); ++i) (*hello.token)[i] = static_cast<std::uint8_t>(0xa1 + 7 * i);
  const Bytes inputs = encode(someInputs());
  say(encode(hello), true);
  say(inputs, false);
  for (int i = 0; i < 20; ++i) step();
  ASSERT_EQ(heard_.size(), 2u);  // what was sent did arrive
  EXPECT_EQ(heard_[1], inputs);
  EXPECT_EQ(received_, 2);
  EXPECT_FALSE(isReadable(bytesOf(kName)));
  EXPECT_FALSE(isReadable({hello.token->begin(), hello.token->end()}));
  EXPECT_FALSE(isReadable(inputs));
}

// The check above would find it.
TEST_F(TrafficSecrecyTest, WhatIsNotSealedIsFound) {
  network_.socket(kClient)->send(kServer, bytesOf("xx" + std::string(kName) + "yy"), now_);
  EXPECT_TRUE(isReadable(bytesOf(kName)));
}

TEST_F(TrafficSecrecyTest, EqualMessagesGiveDifferentDatagrams) {
  connect();
  const Bytes inputs = encode(someInputs());
  for (int i = 0; i < 200; ++i) say(inputs, false);
  const std::vector<Bytes> sealed = sealedByClient();
  ASSERT_GE(sealed.size(), 200u);
  std::set<Bytes> parts;  // every eight bytes of ciphertext and tag
  constexpr std::size_t kPart = 8;
  std::size_t count = 0;
  for (const Bytes& datagram : sealed) {
    for (std::size_t at = kHead; at + kPart <= datagram.size(); at += kPart) {
      const auto begin = datagram.begin() + static_cast<std::ptrdiff_t>(at);
      parts.insert(Bytes(begin, begin + kPart));
      ++count;
    }
  }
  EXPECT_EQ(parts.size(), count);
}

// Whoever reads the wire cannot tell with which secret key the server or the client began.
TEST_F(TrafficSecrecyTest, EveryHandshakeHasItsOwnKeys) {
  connect();
  EnetLink second{network_.socket(addressAt("192.0.2.2", 4000)), {kServer}, {}};
  for (int i = 0; i < 100; ++i) {
    step();
    second.service(now_, [](std::span<const std::uint8_t>) {});
  }
  ASSERT_EQ(second.state(), EnetLink::State::kConnected);
  std::set<Bytes> exchanges;
  for (const DatagramNetwork::Sent& sent : network_.sent()) {
    const auto accept = decodeAccept(sent.bytes);
    const auto open = decodeOpen(sent.bytes);
    if (accept) exchanges.insert({accept->exchange.begin(), accept->exchange.begin() + sizeof(CryptoKey)});
    if (open) exchanges.insert({open->exchange.begin(), open->exchange.begin() + sizeof(CryptoKey)});
  }
  EXPECT_EQ(exchanges.size(), 4u);
}

TEST_F(TrafficSecrecyTest, EveryFlippedBitIsRefused) {
  connect();
  say(encode(someInputs()), false);
  step();
  ASSERT_EQ(heard_.size(), 1u);
  Bytes recorded;
  network_.setFilter([&](const DatagramNetwork::Sent& sent) {
    if (sent.from == kClient) recorded = sent.bytes;
    return sent.from != kClient;
  });
  say(encode(someInputs()), false);
  ASSERT_GT(recorded.size(), 40u);
  for (std::size_t bit = 0; bit < 8 * recorded.size(); ++bit) {
    Bytes flipped = recorded;
    flipped[bit / 8] = static_cast<std::uint8_t>(flipped[bit / 8] ^ 1 << bit % 8);
    network_.inject(kClient, kServer, flipped);
  }
  step();
  EXPECT_EQ(heard_.size(), 1u);
  network_.inject(kClient, kServer, recorded);
  step();
  EXPECT_EQ(heard_.size(), 2u);
}

}  // namespace
}  // namespace platon::traffic_secrecy_test
