#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "protocol/bytes.h"

namespace platon {

/// A secret or public 32-byte value: an X25519 key, a key of ChaCha20-Poly1305, a pre-shared key.
using CryptoKey = std::array<std::uint8_t, 32>;

/// Overwrites a key that is not needed any more.
void wipe(CryptoKey& key);

/// An X25519 key pair.
struct KeyPair {
  CryptoKey secretKey{};
  CryptoKey publicKey{};

  /// The pair with this secret key.
  static KeyPair of(const CryptoKey& secretKey);
  /// A new pair from the random numbers of the system.
  static KeyPair random();
};

/// What both sides have after the handshake: one key for each direction. Each copy forgets its keys at its end.
struct SessionKeys {
  CryptoKey toServer{};
  CryptoKey toClient{};

  ~SessionKeys();

  friend bool operator==(const SessionKeys&, const SessionKeys&) = default;
};

inline constexpr std::size_t kTagBytes = 16;

/// The key exchange Noise_NKpsk0_25519_ChaChaPoly_BLAKE2b of the Noise Protocol Framework, revision 34. The client
/// knows the server's public key in advance; the pre-shared key is derived from the password.
///
///     <- s
///     ...
///     -> psk, e, es
///     <- e, ee
///
/// The first message proves that the client knows the pre-shared key, the second that the server knows its secret key.
/// The session keys stay secret even if both become known later. Neither side reads a clock or a random source.
class NoiseExchange {
 public:
  /// Size of a message without its payload.
  static constexpr std::size_t kOverhead = sizeof(CryptoKey) + kTagBytes;

  /// Both sides must give the same prologue, the server's public key, and the pre-shared key.
  NoiseExchange(ByteSpan prologue, const CryptoKey& serverKey, const CryptoKey& presharedKey);
  NoiseExchange(const NoiseExchange&) = default;
  NoiseExchange& operator=(const NoiseExchange&) = default;
  /// Forgets the keys.
  ~NoiseExchange();

  /// Client: the first message.
  Bytes writeFirst(const KeyPair& clientEphemeral, ByteSpan payload);
  /// Server: the payload of the first message; nothing if the client does not know the pre-shared key.
  std::optional<Bytes> readFirst(const KeyPair& server, ByteSpan message);
  /// Server: the second message, after readFirst.
  Bytes writeSecond(const KeyPair& serverEphemeral, ByteSpan payload);
  /// Client: the payload of the second message; nothing if the server does not know its secret key.
  std::optional<Bytes> readSecond(ByteSpan message);
  /// Both, after the second message.
  SessionKeys split() const;

 private:
  using Hash = std::array<std::uint8_t, 64>;

  void mixHash(ByteSpan data);
  void mixKey(ByteSpan input);
  void mixKeyAndHash(ByteSpan input);
  bool mixExchange(const CryptoKey& secretKey, const CryptoKey& publicKey);
  Bytes encryptAndHash(ByteSpan plaintext);
  std::optional<Bytes> decryptAndHash(ByteSpan sealed);
  Bytes writeEphemeral(ByteSpan ephemeral);

  Hash hash_{};
  Hash chainingKey_{};
  CryptoKey key_{};
  std::uint64_t nonce_ = 0;
  CryptoKey serverKey_;
  CryptoKey presharedKey_;
  KeyPair clientEphemeral_{};  // the client's; of the server's side only `publicKey` is known
};

/// ChaCha20-Poly1305 (RFC 8439) with the nonce of the Noise framework: four zero bytes, then the counter, least
/// significant byte first. `sealed` has kTagBytes more than `plaintext`. A nonce must never be used twice with one key.
void sealWith(const CryptoKey& key, std::uint64_t nonce, ByteSpan associated, ByteSpan plaintext,
              std::span<std::uint8_t> sealed);

/// False if the tag is wrong; `plaintext` is then undefined. `sealed` has at least kTagBytes.
bool openWith(const CryptoKey& key, std::uint64_t nonce, ByteSpan associated, ByteSpan sealed,
              std::span<std::uint8_t> plaintext);

}  // namespace platon
