#pragma once

#include <cstdint>
#include <span>

#include "protocol/transport/noise.h"

namespace platon {

/// ChaCha20-Poly1305 (RFC 8439) with the nonce of the Noise framework: four zero bytes, then the counter, least
/// significant byte first. `sealed` has kTagBytes more than `plaintext`. A nonce must never be used twice with one key.
void sealWith(const CryptoKey& key, std::uint64_t nonce, ByteSpan associated, ByteSpan plaintext,
              std::span<std::uint8_t> sealed);

/// False if the tag is wrong; `plaintext` is then undefined. `sealed` has at least kTagBytes.
bool openWith(const CryptoKey& key, std::uint64_t nonce, ByteSpan associated, ByteSpan sealed,
              std::span<std::uint8_t> plaintext);

}  // namespace platon
