#include "protocol/transport/cookie_jar.h"

#include <gtest/gtest.h>

#include "tests/support/transport/datagram_network.h"

namespace platon::cookie_jar_test {
namespace {

using std::chrono::seconds;

const SocketAddress kClient = addressAt("192.0.2.1", 4000);
constexpr CryptoKey kClientKey{5};
constexpr Moment kNow = seconds(1000);

TEST(CookieJar, ACookieIsValidForTheSameClientOnly) {
  const CookieJar jar(CryptoKey{1});
  const Cookie cookie = jar.make(kClient, kClientKey, kNow);
  EXPECT_TRUE(jar.isValid(cookie, kClient, kClientKey, kNow));
  EXPECT_FALSE(jar.isValid(cookie, addressAt("192.0.2.1", 4001), kClientKey, kNow));
  EXPECT_FALSE(jar.isValid(cookie, addressAt("192.0.2.2", 4000), kClientKey, kNow));
  EXPECT_FALSE(jar.isValid(cookie, kClient, CryptoKey{6}, kNow));
  EXPECT_FALSE(CookieJar(CryptoKey{2}).isValid(cookie, kClient, kClientKey, kNow));
}

TEST(CookieJar, EveryFlippedBitIsInvalid) {
  const CookieJar jar(CryptoKey{1});
  const Cookie cookie = jar.make(kClient, kClientKey, kNow);
  for (std::size_t bit = 0; bit < 8 * cookie.size(); ++bit) {
    Cookie damaged = cookie;
    damaged[bit / 8] ^= static_cast<std::uint8_t>(1 << bit % 8);
    EXPECT_FALSE(jar.isValid(damaged, kClient, kClientKey, kNow)) << "bit " << bit;
  }
}

TEST(CookieJar, ACookieIsValidInItsEpochAndTheNext) {
  const CookieJar jar(CryptoKey{1});
  const Moment begin = 20 * CookieJar::kEpoch;
  const Cookie cookie = jar.make(kClient, kClientKey, begin);
  EXPECT_TRUE(jar.isValid(cookie, kClient, kClientKey, begin + 2 * CookieJar::kEpoch - seconds(1)));
  EXPECT_FALSE(jar.isValid(cookie, kClient, kClientKey, begin + 2 * CookieJar::kEpoch));
  EXPECT_FALSE(jar.isValid(cookie, kClient, kClientKey, begin + 256 * CookieJar::kEpoch));
}

}  // namespace
}  // namespace platon::cookie_jar_test
