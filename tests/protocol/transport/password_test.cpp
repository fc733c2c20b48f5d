#include "protocol/transport/password.h"

#include <gtest/gtest.h>

#include <vector>

#include "protocol/transport/server_identity.h"

namespace platon::password_test {
namespace {

TEST(Password, GivesThePresharedKeyOfEachServer) {
  const Password password("sesame");
  EXPECT_FALSE(password.empty());
  for (const CryptoKey& server : {CryptoKey{}, CryptoKey{1}, CryptoKey{2}}) {
    EXPECT_EQ(password.keyFor(server), presharedKeyOf("sesame", server));
  }
}

TEST(Password, CopiesDeriveTheKeyOfAServerOnce) {
  const std::vector<Password> copies(3, Password("sesame"));
  EXPECT_EQ(copies[0].derivations(), 0u);
  const CryptoKey key = copies[0].keyFor(CryptoKey{1});
  EXPECT_EQ(copies[1].keyFor(CryptoKey{1}), key);
  EXPECT_EQ(copies[2].keyFor(CryptoKey{1}), key);
  for (const Password& copy : copies) EXPECT_EQ(copy.derivations(), 1u);
  EXPECT_NE(copies[1].keyFor(CryptoKey{2}), key);
  EXPECT_EQ(copies[0].derivations(), 2u);
}

TEST(Password, AnEmptyTextIsNone) {
  EXPECT_TRUE(Password().empty());
  EXPECT_TRUE(Password("").empty());
}

}  // namespace
}  // namespace platon::password_test
