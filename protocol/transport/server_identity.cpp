#include "protocol/transport/server_identity.h"

#include <sodium.h>

#include <algorithm>
#include <new>

namespace platon {
namespace {

constexpr std::string_view kSecretPrefix = "platon-server-key ";
constexpr int kVariant = sodium_base64_VARIANT_URLSAFE_NO_PADDING;

}  // namespace

ServerIdentity::ServerIdentity(const CryptoKey& secret) : secret_(secret) {
  std::array<std::uint8_t, crypto_sign_SECRETKEYBYTES> signing;
  crypto_sign_seed_keypair(publicKey_.data(), signing.data(), secret.data());
  CryptoKey exchange;
  crypto_sign_ed25519_sk_to_curve25519(exchange.data(), signing.data());
  exchange_ = KeyPair::of(exchange);
  sodium_memzero(signing.data(), signing.size());
  wipe(exchange);
}

ServerIdentity ServerIdentity::random() {
  CryptoKey secret;
  randombytes_buf(secret.data(), secret.size());
  ServerIdentity identity(secret);
  wipe(secret);
  return identity;
}

std::optional<ServerIdentity> ServerIdentity::parse(std::string_view text) {
  if (!text.starts_with(kSecretPrefix)) return std::nullopt;
  const std::optional<CryptoKey> secret = keyOf(text.substr(kSecretPrefix.size()));
  return secret ? std::optional(ServerIdentity(*secret)) : std::nullopt;
}

std::string ServerIdentity::text() const { return std::string(kSecretPrefix) + textOf(secret_); }

std::optional<CryptoKey> exchangeKeyOf(const CryptoKey& publicKey) {
  CryptoKey exchange;
  if (crypto_sign_ed25519_pk_to_curve25519(exchange.data(), publicKey.data()) != 0) return std::nullopt;
  return exchange;
}

std::string textOf(const CryptoKey& publicKey) {
  std::string text(sodium_base64_encoded_len(publicKey.size(), kVariant), '\0');
  sodium_bin2base64(text.data(), text.size(), publicKey.data(), publicKey.size(), kVariant);
  text.pop_back();  // the terminating zero
  return text;
}

std::optional<CryptoKey> keyOf(std::string_view text) {
  CryptoKey key;
  std::size_t size = 0;
  const char* end = nullptr;
  const int result =
      sodium_base642bin(key.data(), key.size(), text.data(), text.size(), nullptr, &size, &end, kVariant);
  if (result != 0 || size != key.size() || end != text.data() + text.size()) return std::nullopt;
  return key;
}

CryptoKey presharedKeyOf(std::string_view password, const CryptoKey& serverKey) {
  std::array<std::uint8_t, crypto_pwhash_SALTBYTES> salt;
  crypto_generichash(salt.data(), salt.size(), serverKey.data(), serverKey.size(), nullptr, 0);
  CryptoKey key;
  if (crypto_pwhash(key.data(), key.size(), password.data(), password.size(), salt.data(),
                    crypto_pwhash_OPSLIMIT_INTERACTIVE, crypto_pwhash_MEMLIMIT_INTERACTIVE,
                    crypto_pwhash_ALG_ARGON2ID13) != 0) {
    throw std::bad_alloc();
  }
  return key;
}

}  // namespace platon
