#include "protocol/transport/server_identity.h"

#include <sodium.h>

#include <algorithm>
#include <new>

namespace platon {
namespace {

constexpr std::string_view kSecretPrefix = "platon-server-key ";
constexpr int kVariant = sodium_base64_VARIANT_URLSAFE_NO_PADDING;

using SigningKey = std::array<std::uint8_t, crypto_sign_SECRETKEYBYTES>;

template <std::size_t kSize>
std::string base64Of(const std::array<std::uint8_t, kSize>& bytes) {
  std::string text(sodium_base64_encoded_len(kSize, kVariant), '\0');
  sodium_bin2base64(text.data(), text.size(), bytes.data(), kSize, kVariant);
  text.pop_back();  // the terminating zero
  return text;
}

template <std::size_t kSize>
std::optional<std::array<std::uint8_t, kSize>> bytesOf(std::string_view base64) {
  std::array<std::uint8_t, kSize> bytes;
  std::size_t size = 0;
  const char* end = nullptr;
  const int result =
      sodium_base642bin(bytes.data(), kSize, base64.data(), base64.size(), nullptr, &size, &end, kVariant);
  if (result != 0 || size != kSize || end != base64.data() + base64.size()) return std::nullopt;
  return bytes;
}

const std::uint8_t* bytesOfText(std::string_view text) { return reinterpret_cast<const std::uint8_t*>(text.data()); }

}  // namespace

ServerIdentity::ServerIdentity(const CryptoKey& secret) : secret_(secret) {
  SigningKey signing;
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

Signature ServerIdentity::sign(std::string_view message) const {
  SigningKey signing;
  CryptoKey publicKey;
  crypto_sign_seed_keypair(publicKey.data(), signing.data(), secret_.data());
  Signature signature;
  crypto_sign_detached(signature.data(), nullptr, bytesOfText(message), message.size(), signing.data());
  sodium_memzero(signing.data(), signing.size());
  return signature;
}

bool isSignature(const Signature& signature, std::string_view message, const CryptoKey& publicKey) {
  return crypto_sign_verify_detached(signature.data(), bytesOfText(message), message.size(), publicKey.data()) == 0;
}

std::optional<CryptoKey> exchangeKeyOf(const CryptoKey& publicKey) {
  CryptoKey exchange;
  if (crypto_sign_ed25519_pk_to_curve25519(exchange.data(), publicKey.data()) != 0) return std::nullopt;
  return exchange;
}

std::string textOf(const CryptoKey& publicKey) { return base64Of(publicKey); }

std::optional<CryptoKey> keyOf(std::string_view text) { return bytesOf<std::tuple_size_v<CryptoKey>>(text); }

std::string textOf(const Signature& signature) { return base64Of(signature); }

std::optional<Signature> signatureOf(std::string_view text) { return bytesOf<std::tuple_size_v<Signature>>(text); }

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
