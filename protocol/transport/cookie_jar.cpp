#include "protocol/transport/cookie_jar.h"

#include <sodium.h>

namespace platon {
namespace {

std::uint64_t epochAt(Moment now) { return static_cast<std::uint64_t>(now / CookieJar::kEpoch); }

template <class Number>
void mix(crypto_generichash_state& state, Number value) {
  std::array<std::uint8_t, sizeof(Number)> bytes;
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::uint8_t>(value >> (8 * i));
  crypto_generichash_update(&state, bytes.data(), bytes.size());
}

}  // namespace

Cookie CookieJar::makeFor(std::uint64_t epoch, const SocketAddress& client, const CryptoKey& clientKey) const {
  Cookie cookie;
  cookie[0] = static_cast<std::uint8_t>(epoch);
  crypto_generichash_state state;
  crypto_generichash_init(&state, secret_.data(), secret_.size(), cookie.size() - 1);
  mix(state, epoch);
  crypto_generichash_update(&state, client.ip.bytes.data(), client.ip.bytes.size());
  mix(state, client.port);
  crypto_generichash_update(&state, clientKey.data(), clientKey.size());
  crypto_generichash_final(&state, cookie.data() + 1, cookie.size() - 1);
  return cookie;
}

Cookie CookieJar::make(const SocketAddress& client, const CryptoKey& clientKey, Moment now) const {
  return makeFor(epochAt(now), client, clientKey);
}

bool CookieJar::isValid(const Cookie& cookie, const SocketAddress& client, const CryptoKey& clientKey,
                        Moment now) const {
  std::uint64_t epoch = epochAt(now);
  if (cookie[0] != static_cast<std::uint8_t>(epoch)) --epoch;
  const Cookie expected = makeFor(epoch, client, clientKey);
  return sodium_memcmp(cookie.data(), expected.data(), cookie.size()) == 0;
}

}  // namespace platon
