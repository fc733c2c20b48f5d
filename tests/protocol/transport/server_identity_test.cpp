#include "protocol/transport/server_identity.h"

#include <gtest/gtest.h>

#include "tests/support/transport/hex.h"

namespace platon::server_identity_test {
namespace {

// RFC 8032, section 7.1, test 1.
const CryptoKey kSecret = keyFromHex("9d61b19deffd5a60ba844af492ec2cc44449c5697b326919703bac031cae7f60");

TEST(ServerIdentity, HasThePublicKeyOfTheRfc) {
  EXPECT_EQ(toHex(ServerIdentity(kSecret).publicKey()),
            "d75a980182b10ab7d54bfed3c964073a0ee172f3daa62325af021a68f707511a");
}

TEST(ServerIdentity, ClientsDeriveTheSameExchangeKey) {
  for (int i = 0; i < 10; ++i) {
    const ServerIdentity identity = ServerIdentity::random();
    EXPECT_EQ(exchangeKeyOf(identity.publicKey()), identity.exchangeKeys().open);
  }
  EXPECT_EQ(exchangeKeyOf(CryptoKey{}), std::nullopt);  // of small order
}

TEST(ServerIdentity, ItsTextIsReadBack) {
  const ServerIdentity identity(kSecret);
  const std::string text = identity.text();
  EXPECT_EQ(text, "platon-server-key nWGxne_9WmC6hEr0kuwsxERJxWl7MmkZcDusAxyuf2A");
  EXPECT_EQ(ServerIdentity::parse(text)->publicKey(), identity.publicKey());
  EXPECT_FALSE(ServerIdentity::parse(text.substr(0, text.size() - 1)));
  EXPECT_FALSE(ServerIdentity::parse(text + "A"));
  EXPECT_FALSE(ServerIdentity::parse(text.substr(1)));
  EXPECT_FALSE(ServerIdentity::parse(""));
}

TEST(ServerIdentity, APublicKeyHas43Characters) {
  const CryptoKey key = ServerIdentity::random().publicKey();
  EXPECT_EQ(textOf(key).size(), 43u);
  EXPECT_EQ(keyOf(textOf(key)), key);
  EXPECT_EQ(keyOf("not a key"), std::nullopt);
}

TEST(PresharedKey, DependsOnPasswordAndServer) {
  const CryptoKey key = presharedKeyOf("secret", CryptoKey{1});
  EXPECT_EQ(key, presharedKeyOf("secret", CryptoKey{1}));
  EXPECT_NE(key, presharedKeyOf("Secret", CryptoKey{1}));
  EXPECT_NE(key, presharedKeyOf("secret", CryptoKey{2}));
}

}  // namespace
}  // namespace platon::server_identity_test
