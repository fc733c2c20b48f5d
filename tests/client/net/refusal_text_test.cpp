#include "client/net/refusal_text.h"

#include <gtest/gtest.h>

#include "protocol/limits.h"
#include "protocol/transport/server_identity.h"
#include "protocol/version_text.h"
#include "tests/support/transport/datagram_network.h"

namespace platon::refusal_text_test {
namespace {

const SocketAddress kServer = addressAt("198.51.100.1", 7777);
const SocketAddress kClient = addressAt("192.0.2.1", 4000);

// What a client says whose handshake is answered with this refusal.
Connection::Refused refusedWith(std::uint32_t version, RefusalReason reason, const std::string& text = "") {
  DatagramNetwork network;
  const KeyPair keys = KeyPair::random();
  ClientGate gate(network.socket(kClient), {kServer}, {}, keys);
  gate.update(Moment{});
  network.inject(kServer, kClient,
                 encode(Refusal{static_cast<std::uint16_t>(version), echoOf(keys.open), reason, text}));
  gate.receive(Moment{});
  return refusalOf(gate);
}

TEST(RefusalText, SaysWhichProgramToUpdate) {
  const Connection::Refused newer = refusedWith(kProtocolVersion + 1, RefusalReason::kWrongVersion);
  EXPECT_TRUE(newer.permanent);
  EXPECT_EQ(newer.reason, otherVersionText("protocol", kProtocolVersion + 1, kProtocolVersion));
  const Connection::Refused older = refusedWith(kProtocolVersion - 1, RefusalReason::kWrongVersion);
  EXPECT_EQ(older.reason, otherVersionText("protocol", kProtocolVersion - 1, kProtocolVersion));
}

TEST(RefusalText, EveryReasonHasItsSentence) {
  EXPECT_EQ(refusedWith(kProtocolVersion, RefusalReason::kPassword).reason, "the password is wrong");
  EXPECT_EQ(refusedWith(kProtocolVersion, RefusalReason::kBanned, "banned for a day").reason, "banned for a day");
  EXPECT_EQ(refusedWith(kProtocolVersion, RefusalReason::kBanned).reason, "you are banned from this server");
  EXPECT_EQ(refusedWith(kProtocolVersion, RefusalReason::kBanned, "\u200b").reason, "you are banned from this server");
  EXPECT_FALSE(refusedWith(kProtocolVersion, RefusalReason::kFull).permanent);
  EXPECT_FALSE(refusedWith(kProtocolVersion, RefusalReason::kAddress).permanent);
}

TEST(RefusalText, SaysThatAPasswordOrTheKnownServerIsMissing) {
  DatagramNetwork network;
  const KeyPair keys = KeyPair::random();
  const CryptoKey identity = ServerIdentity::random().publicKey();
  const auto textFor = [&](const ServerKnowledge& knowledge, bool needsPassword = true) {
    ClientGate gate(network.socket(kClient), {kServer}, knowledge, keys);
    gate.update(Moment{});
    network.inject(kServer, kClient, encode(CookieReply{echoOf(keys.open), needsPassword, identity, {}}));
    gate.receive(Moment{});
    return refusalOf(gate).reason;
  };
  EXPECT_NE(textFor({}).find("--password-file"), std::string::npos);
  EXPECT_NE(textFor({CryptoKey{1}}).find("known_servers"), std::string::npos);
  EXPECT_EQ(textFor({std::nullopt, Password("sesame")}, false),
            "the server does not ask for a password: leave out --password-file if that is right");
}

}  // namespace
}  // namespace platon::refusal_text_test
