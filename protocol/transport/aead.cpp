#include "protocol/transport/aead.h"

#include <sodium.h>

#include <cassert>

namespace platon {
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
