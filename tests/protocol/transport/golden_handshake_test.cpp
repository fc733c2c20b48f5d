#include <gtest/gtest.h>

#include <algorithm>

#include "protocol/limits.h"
#include "protocol/transport/handshake.h"
#include "protocol/transport/sealed_channel.h"
#include "protocol/transport/server_identity.h"
#include "tests/net/support/hex.h"
#include "tests/protocol/documented_bytes.h"

namespace platon::golden_handshake_test {
namespace {

CryptoKey keyOfBytes(std::uint8_t byte) {
  CryptoKey key;
  key.fill(byte);
  return key;
}

/// The handshake of docs/protocol.md, with the keys that the page gives.
struct Handshake {
  Handshake() {
    cookie.fill(4);
    const CryptoKey psk = presharedKeyOf("open sesame", identity.publicKey());
    NoiseExchange clientSide(prologueOf(identity.publicKey()), *exchangeKeyOf(identity.publicKey()), psk);
    NoiseExchange serverSide(prologueOf(identity.publicKey()), identity.exchangeKeys().publicKey, psk);
    Open open{cookie, {}};
    const Bytes first = clientSide.writeFirst(client, {});
    std::copy(first.begin(), first.end(), open.exchange.begin());
    EXPECT_TRUE(serverSide.readFirst(identity.exchangeKeys(), first));
    Accept accept{echoOf(client.publicKey), {}};
    const Bytes second = serverSide.writeSecond(KeyPair::of(keyOfBytes(3)), Bytes{5, 0});
    std::copy(second.begin(), second.end(), accept.exchange.begin());
    EXPECT_EQ(clientSide.readSecond(second), (Bytes{5, 0}));
    EXPECT_EQ(clientSide.split(), serverSide.split());
    SealedChannel toServer(SealedChannel::Side::kClient, clientSide.split(), 5);
    SealedChannel toClient(SealedChannel::Side::kServer, serverSide.split(), 5);
    datagrams["knock"] = encode(Knock{static_cast<std::uint16_t>(kProtocolVersion), client.publicKey});
    datagrams["cookie"] = encode(CookieReply{echoOf(client.publicKey), true, identity.publicKey(), cookie});
    datagrams["open"] = encode(open);
    datagrams["accept"] = encode(accept);
    datagrams["sealed-to-server"] = toServer.seal(Bytes{1, 2, 3});
    datagrams["sealed-to-client"] = toClient.seal(Bytes{1, 2, 3});
    datagrams["query"] = encode(Query{0x0102030405060708});
    datagrams["info"] = encode(Info{static_cast<std::uint16_t>(kProtocolVersion), 0x0102030405060708,
                                    identity.publicKey(), true, 3, 16, "Platon", "0.1.0"});
    datagrams["refusal"] = encode(Refusal{static_cast<std::uint16_t>(kProtocolVersion), echoOf(client.publicKey),
                                          RefusalReason::kBanned, "until tomorrow"});
  }

  KeyPair client = KeyPair::of(keyOfBytes(1));
  ServerIdentity identity{keyOfBytes(2)};
  Cookie cookie{};
  std::map<std::string, Bytes> datagrams;
};

// The page leaves out the zeros at the end.
Bytes withoutPadding(Bytes bytes) {
  const auto end = std::find_if(bytes.rbegin(), bytes.rend(), [](std::uint8_t byte) { return byte != 0; }).base();
  bytes.erase(end, bytes.end());
  return bytes;
}

TEST(GoldenHandshake, TheDocumentedDatagramsAreThoseOfTheProgram) {
  const std::map<std::string, Bytes> page = documentedBytes();
  for (const auto& [name, datagram] : Handshake().datagrams) {
    ASSERT_TRUE(page.contains(name)) << name;
    EXPECT_EQ(toHex(page.at(name)), toHex(withoutPadding(datagram))) << name;
  }
}

}  // namespace
}  // namespace platon::golden_handshake_test
