#include "protocol/transport/noise.h"

#include <algorithm>
#include <cassert>
#include <string_view>
#include <utility>

#include <sodium.h>

namespace platon {
namespace {

constexpr std::string_view kName = "Noise_NKpsk0_25519_ChaChaPoly_BLAKE2b";
constexpr std::size_t kHashBytes = 64;
constexpr std::size_t kBlockBytes = 128;  // of BLAKE2b

using Hash = std::array<std::uint8_t, kHashBytes>;

Hash hashOf(std::initializer_list<ByteSpan> parts) {
  crypto_generichash_state state;
  crypto_generichash_init(&state, nullptr, 0, kHashBytes);
  for (const ByteSpan part : parts) crypto_generichash_update(&state, part.data(), part.size());
  Hash hash;
  crypto_generichash_final(&state, hash.data(), hash.size());
  return hash;
}

// HMAC (RFC 2104) with BLAKE2b-512. The key is a hash, so it is shorter than a block.
Hash hmac(const Hash& key, std::initializer_list<ByteSpan> parts) {
  std::array<std::uint8_t, kBlockBytes> inner;
  std::array<std::uint8_t, kBlockBytes> outer;
  inner.fill(0x36);
  outer.fill(0x5c);
  for (std::size_t i = 0; i < key.size(); ++i) {
    inner[i] ^= key[i];
    outer[i] ^= key[i];
  }
  crypto_generichash_state state;
  crypto_generichash_init(&state, nullptr, 0, kHashBytes);
  crypto_generichash_update(&state, inner.data(), inner.size());
  for (const ByteSpan part : parts) crypto_generichash_update(&state, part.data(), part.size());
  Hash hash;
  crypto_generichash_final(&state, hash.data(), hash.size());
  return hashOf({outer, hash});
}

// HKDF of the framework, section 4.3, with up to three outputs.
std::array<Hash, 3> hkdf(const Hash& chainingKey, ByteSpan input) {
  const Hash temporary = hmac(chainingKey, {input});
  constexpr std::uint8_t one = 1;
  constexpr std::uint8_t two = 2;
  constexpr std::uint8_t three = 3;
  const Hash first = hmac(temporary, {{&one, 1}});
  const Hash second = hmac(temporary, {first, {&two, 1}});
  const Hash third = hmac(temporary, {second, {&three, 1}});
  return {first, second, third};
}

CryptoKey firstHalf(const Hash& hash) {
  CryptoKey key;
  std::copy_n(hash.begin(), key.size(), key.begin());
  return key;
}

}  // namespace

void wipe(CryptoKey& key) { sodium_memzero(key.data(), key.size()); }

KeyPair KeyPair::of(const CryptoKey& secretKey) {
  KeyPair pair{secretKey, {}};
  crypto_scalarmult_base(pair.publicKey.data(), secretKey.data());
  return pair;
}

KeyPair KeyPair::random() {
  CryptoKey secretKey;
  randombytes_buf(secretKey.data(), secretKey.size());
  const KeyPair pair = of(secretKey);
  wipe(secretKey);
  return pair;
}

SessionKeys::~SessionKeys() {
  wipe(toServer);
  wipe(toClient);
}

NoiseExchange::NoiseExchange(ByteSpan prologue, const CryptoKey& serverKey, const CryptoKey& presharedKey)
    : serverKey_(serverKey), presharedKey_(presharedKey) {
  static_assert(kName.size() <= kHashBytes);
  std::copy(kName.begin(), kName.end(), hash_.begin());
  chainingKey_ = hash_;
  mixHash(prologue);
  mixHash(serverKey);
}

NoiseExchange::~NoiseExchange() {
  sodium_memzero(chainingKey_.data(), chainingKey_.size());
  for (CryptoKey* key : {&key_, &presharedKey_, &clientEphemeral_.secretKey}) wipe(*key);
}

void NoiseExchange::mixHash(ByteSpan data) { hash_ = hashOf({hash_, data}); }

void NoiseExchange::mixKey(ByteSpan input) {
  const std::array<Hash, 3> derived = hkdf(chainingKey_, input);
  chainingKey_ = derived[0];
  key_ = firstHalf(derived[1]);
  nonce_ = 0;
}

void NoiseExchange::mixKeyAndHash(ByteSpan input) {
  const std::array<Hash, 3> derived = hkdf(chainingKey_, input);
  chainingKey_ = derived[0];
  mixHash(derived[1]);
  key_ = firstHalf(derived[2]);
  nonce_ = 0;
}

// False for a public key of small order, whose shared secret everybody knows.
bool NoiseExchange::mixExchange(const CryptoKey& secretKey, const CryptoKey& publicKey) {
  CryptoKey shared;
  if (crypto_scalarmult(shared.data(), secretKey.data(), publicKey.data()) != 0) return false;
  mixKey(shared);
  wipe(shared);
  return true;
}

Bytes NoiseExchange::encryptAndHash(ByteSpan plaintext) {
  Bytes sealed(plaintext.size() + kTagBytes);
  sealWith(key_, nonce_++, hash_, plaintext, sealed);
  mixHash(sealed);
  return sealed;
}

std::optional<Bytes> NoiseExchange::decryptAndHash(ByteSpan sealed) {
  if (sealed.size() < kTagBytes) return std::nullopt;
  Bytes plaintext(sealed.size() - kTagBytes);
  if (!openWith(key_, nonce_++, hash_, sealed, plaintext)) return std::nullopt;
  mixHash(sealed);
  return plaintext;
}

// With a pre-shared key, the framework also mixes each ephemeral key into the key.
Bytes NoiseExchange::writeEphemeral(ByteSpan ephemeral) {
  mixHash(ephemeral);
  mixKey(ephemeral);
  return {ephemeral.begin(), ephemeral.end()};
}

Bytes NoiseExchange::writeFirst(const KeyPair& clientEphemeral, ByteSpan payload) {
  clientEphemeral_ = clientEphemeral;
  mixKeyAndHash(presharedKey_);
  Bytes message = writeEphemeral(clientEphemeral.publicKey);
  if (!mixExchange(clientEphemeral.secretKey, serverKey_)) return {};
  const Bytes sealed = encryptAndHash(payload);
  message.insert(message.end(), sealed.begin(), sealed.end());
  return message;
}

std::optional<Bytes> NoiseExchange::readFirst(const KeyPair& server, ByteSpan message) {
  if (message.size() < kOverhead) return std::nullopt;
  std::copy_n(message.begin(), sizeof(CryptoKey), clientEphemeral_.publicKey.begin());
  mixKeyAndHash(presharedKey_);
  writeEphemeral(clientEphemeral_.publicKey);
  if (!mixExchange(server.secretKey, clientEphemeral_.publicKey)) return std::nullopt;
  return decryptAndHash(message.subspan(sizeof(CryptoKey)));
}

Bytes NoiseExchange::writeSecond(const KeyPair& serverEphemeral, ByteSpan payload) {
  Bytes message = writeEphemeral(serverEphemeral.publicKey);
  if (!mixExchange(serverEphemeral.secretKey, clientEphemeral_.publicKey)) return {};
  const Bytes sealed = encryptAndHash(payload);
  message.insert(message.end(), sealed.begin(), sealed.end());
  return message;
}

std::optional<Bytes> NoiseExchange::readSecond(ByteSpan message) {
  if (message.size() < kOverhead) return std::nullopt;
  CryptoKey serverEphemeral;
  std::copy_n(message.begin(), sizeof(CryptoKey), serverEphemeral.begin());
  writeEphemeral(serverEphemeral);
  if (!mixExchange(clientEphemeral_.secretKey, serverEphemeral)) return std::nullopt;
  return decryptAndHash(message.subspan(sizeof(CryptoKey)));
}

SessionKeys NoiseExchange::split() const {
  std::array<Hash, 3> derived = hkdf(chainingKey_, {});
  SessionKeys keys{firstHalf(derived[0]), firstHalf(derived[1])};
  sodium_memzero(derived.data(), sizeof derived);
  return keys;
}

namespace {

using Nonce = std::array<std::uint8_t, crypto_aead_chacha20poly1305_IETF_NPUBBYTES>;

Nonce nonceOf(std::uint64_t counter) {
  Nonce nonce{};
  for (std::size_t i = 4; i < nonce.size(); ++i) nonce[i] = static_cast<std::uint8_t>(counter >> (8 * (i - 4)));
  return nonce;
}

}  // namespace

void sealWith(const CryptoKey& key, std::uint64_t nonce, ByteSpan associated, ByteSpan plaintext,
              std::span<std::uint8_t> sealed) {
  assert(sealed.size() == plaintext.size() + kTagBytes);
  crypto_aead_chacha20poly1305_ietf_encrypt(sealed.data(), nullptr, plaintext.data(), plaintext.size(),
                                            associated.data(), associated.size(), nullptr, nonceOf(nonce).data(),
                                            key.data());
}

bool openWith(const CryptoKey& key, std::uint64_t nonce, ByteSpan associated, ByteSpan sealed,
              std::span<std::uint8_t> plaintext) {
  assert(sealed.size() >= kTagBytes && plaintext.size() == sealed.size() - kTagBytes);
  return crypto_aead_chacha20poly1305_ietf_decrypt(plaintext.data(), nullptr, nullptr, sealed.data(), sealed.size(),
                                                   associated.data(), associated.size(), nonceOf(nonce).data(),
                                                   key.data()) == 0;
}

}  // namespace platon
