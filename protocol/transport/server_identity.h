#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "protocol/transport/noise.h"

namespace platon {

using Signature = std::array<std::uint8_t, 64>;

/// The long-lived key of a server: Ed25519. Clients remember its public part. The key pair of the key exchange (X25519)
/// is derived from it.
class ServerIdentity {
 public:
  /// The identity of a 32-byte secret.
  explicit ServerIdentity(const CryptoKey& secret);
  static ServerIdentity random();
  /// Reads `text()`; nothing if it is something else.
  static std::optional<ServerIdentity> parse(std::string_view text);

  /// The secret as a line of text, for a file that only the server may read.
  std::string text() const;
  const CryptoKey& publicKey() const { return publicKey_; }
  const KeyPair& exchangeKeys() const { return exchange_; }
  /// The Ed25519 signature of a message: nobody can make it without the secret.
  Signature sign(std::string_view message) const;

 private:
  CryptoKey secret_;
  CryptoKey publicKey_{};
  KeyPair exchange_;
};

/// Whether a signature of the message was made with the secret of this public key.
bool isSignature(const Signature& signature, std::string_view message, const CryptoKey& publicKey);

/// The X25519 key that belongs to an Ed25519 public key; nothing if that is not a valid one.
std::optional<CryptoKey> exchangeKeyOf(const CryptoKey& publicKey);

/// A public key as text, 43 characters, and back.
std::string textOf(const CryptoKey& publicKey);
std::optional<CryptoKey> keyOf(std::string_view text);
/// A signature as text, 86 characters, and back.
std::string textOf(const Signature& signature);
std::optional<Signature> signatureOf(std::string_view text);

/// The pre-shared key of a password for one server, by Argon2id (64 MiB, about 0.1 s). Throws std::bad_alloc if the
/// memory is not available. Without a password, the pre-shared key is 0.
CryptoKey presharedKeyOf(std::string_view password, const CryptoKey& serverKey);

}  // namespace platon
