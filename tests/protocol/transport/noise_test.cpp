#include "protocol/transport/noise.h"

#include <gtest/gtest.h>

#include "tests/net/support/hex.h"

namespace platon::noise_test {
namespace {

// The vector of Noise_NKpsk0_25519_ChaChaPoly_BLAKE2b by cacophony, an independent implementation
// (https://github.com/haskell-cryptography/cacophony, vectors/cacophony.txt).
struct Vector {
  Bytes prologue = fromHex("4a6f686e2047616c74");
  CryptoKey presharedKey = keyFromHex("54686973206973206d7920417573747269616e20706572737065637469766521");
  KeyPair clientEphemeral = KeyPair::of(keyFromHex("893e28b9dc6ca8d611ab664754b8ceb7bac5117349a4439a6b0569da977c464a"));
  KeyPair server = KeyPair::of(keyFromHex("4a3acbfdb163dec651dfa3194dece676d437029c62a408b4c5ea9114246e4893"));
  KeyPair serverEphemeral = KeyPair::of(keyFromHex("bbdb4cdbd309f1a1f2e1456967fe288cadd6f712d65dc7b7793d5e63da6b375b"));
  Bytes firstPayload = fromHex("4c756477696720766f6e204d69736573");
  Bytes first = fromHex(
      "ca35def5ae56cec33dc2036731ab14896bc4c75dbb07a61f879f8e3afa4c794432c362f61a0162a93280a9e1c53edb8ce7487fd12a4d1731"
      "495a24051a5afca8");
  Bytes secondPayload = fromHex("4d757272617920526f746862617264");
  Bytes second = fromHex(
      "95ebc60d2b1fa672c1f46a8aa265ef51bfe38e7ccb39ec5be34069f1448088430e8d0924ed6525d4045188c3b225604c254ac2d8d33a8a3b"
      "0c7f5eb1975ba4");
  Bytes toServerPayload = fromHex("462e20412e20486179656b");
  Bytes toServer = fromHex("4781e2a7bef65e0ae3da3508cf44a8b7a92880077b8e73afaef494");
  Bytes toClientPayload = fromHex("4361726c204d656e676572");
  Bytes toClient = fromHex("f14b1feb6ff970fc3993f1c2383f33fa48138bfc5aa2ee89e40107");

  NoiseExchange side() const { return {prologue, server.publicKey, presharedKey}; }
};

Bytes sealed(const CryptoKey& key, ByteSpan plaintext) {
  Bytes bytes(plaintext.size() + kTagBytes);
  sealWith(key, 0, {}, plaintext, bytes);
  return bytes;
}

TEST(Noise, TheClientAgreesWithCacophony) {
  const Vector vector;
  EXPECT_EQ(toHex(vector.server.publicKey), "31e0303fd6418d2f8c0e78b91f22e8caed0fbe48656dcf4767e4834f701b8f62");
  NoiseExchange client = vector.side();
  EXPECT_EQ(client.writeFirst(vector.clientEphemeral, vector.firstPayload), vector.first);
  EXPECT_EQ(client.readSecond(vector.second), vector.secondPayload);
  const SessionKeys keys = client.split();
  EXPECT_EQ(sealed(keys.toServer, vector.toServerPayload), vector.toServer);
  EXPECT_EQ(sealed(keys.toClient, vector.toClientPayload), vector.toClient);
}

TEST(Noise, TheServerAgreesWithCacophony) {
  const Vector vector;
  NoiseExchange server = vector.side();
  EXPECT_EQ(server.readFirst(vector.server, vector.first), vector.firstPayload);
  EXPECT_EQ(server.writeSecond(vector.serverEphemeral, vector.secondPayload), vector.second);
  EXPECT_EQ(sealed(server.split().toServer, vector.toServerPayload), vector.toServer);
}

TEST(Noise, AnotherPresharedKeyPrologueOrServerKeyIsRefused) {
  const Vector vector;
  Vector psk;
  psk.presharedKey[0] ^= 1;
  Vector prologue;
  prologue.prologue[0] ^= 1;
  Vector key;
  key.server = KeyPair::of(CryptoKey{7});
  for (const Vector& other : {psk, prologue, key}) {
    EXPECT_EQ(other.side().readFirst(other.server, vector.first), std::nullopt);
  }
}

TEST(Noise, EveryFlippedBitIsRefused) {
  const Vector vector;
  for (std::size_t bit = 0; bit < 8 * vector.first.size(); ++bit) {
    Bytes damaged = vector.first;
    damaged[bit / 8] ^= static_cast<std::uint8_t>(1 << bit % 8);
    EXPECT_EQ(vector.side().readFirst(vector.server, damaged), std::nullopt) << "bit " << bit;
  }
  for (std::size_t bit = 0; bit < 8 * vector.second.size(); ++bit) {
    Bytes damaged = vector.second;
    damaged[bit / 8] ^= static_cast<std::uint8_t>(1 << bit % 8);
    NoiseExchange client = vector.side();
    client.writeFirst(vector.clientEphemeral, vector.firstPayload);
    EXPECT_EQ(client.readSecond(damaged), std::nullopt) << "bit " << bit;
  }
}

TEST(Noise, KeysOfSmallOrderAndShortMessagesAreRefused) {
  const Vector vector;
  Bytes message = vector.first;
  std::fill_n(message.begin(), sizeof(CryptoKey), std::uint8_t{0});
  EXPECT_EQ(vector.side().readFirst(vector.server, message), std::nullopt);
  for (std::size_t size = 0; size < NoiseExchange::kOverhead; ++size) {
    EXPECT_EQ(vector.side().readFirst(vector.server, ByteSpan(vector.first).first(size)), std::nullopt);
  }
}

TEST(Noise, RandomPairsDiffer) { EXPECT_NE(KeyPair::random().publicKey, KeyPair::random().publicKey); }

// RFC 7539, appendix A.5, with the nonce of the Noise framework: its first four bytes are 0 there, too.
TEST(Aead, OpensTheVectorOfTheRfc) {
  const CryptoKey key = keyFromHex("1c9240a5eb55d38af333888604f6b5f0473917c1402b80099dca5cbc207075c0");
  const Bytes associated = fromHex("f33388860000000000004e91");
  constexpr std::uint64_t nonce = 0x0807060504030201;
  const Bytes sealed = fromHex(
      "64a0861575861af460f062c79be643bd5e805cfd345cf389f108670ac76c8cb24c6cfc18755d43eea09ee94e382d26b0bdb7b73c321b0100"
      "d4f03b7f355894cf332f830e710b97ce98c8a84abd0b948114ad176e008d33bd60f982b1ff37c8559797a06ef4f0ef61c186324e2b350638"
      "3606907b6a7c02b0f9f6157b53c867e4b9166c767b804d46a59b5216cde7a4e99040c5a40433225ee282a1b0a06c523eaf4534d7f83fa115"
      "5b0047718cbc546a0d072b04b3564eea1b422273f548271a0bb2316053fa76991955ebd63159434ecebb4e466dae5a1073a6727627097a10"
      "49e617d91d361094fa68f0ff77987130305beaba2eda04df997b714d6c6f2c29a6ad5cb4022b02709beead9d67890cbb22392336fea1851f"
      "38");
  Bytes plaintext(sealed.size() - kTagBytes);
  ASSERT_TRUE(openWith(key, nonce, associated, sealed, plaintext));
  EXPECT_TRUE(std::string(plaintext.begin(), plaintext.end()).starts_with("Internet-Drafts are draft documents valid"));
  Bytes again(sealed.size());
  sealWith(key, nonce, associated, plaintext, again);
  EXPECT_EQ(again, sealed);
  EXPECT_FALSE(openWith(key, nonce + 1, associated, sealed, plaintext));
  EXPECT_FALSE(openWith(key, nonce, {}, sealed, plaintext));
}

}  // namespace
}  // namespace platon::noise_test
