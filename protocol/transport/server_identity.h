#pragma once

#include <array>
#include <cstdint>
#include <memory>
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

/// A password, and the pre-shared key that it gives with a server. All copies share that key, so that a program with
/// many clients, or one that reconnects, derives it once. Not for several threads.
class Password {
 public:
  /// An empty text: no password.
  Password(std::string text = {});

  bool empty() const { return shared_->text.empty(); }
  /// As `presharedKeyOf`; takes that time and memory only when the last call was for another server.
  const CryptoKey& keyFor(const CryptoKey& serverKey) const;
  /// How often the key was derived, by all copies together.
  std::uint32_t derivations() const { return shared_->derivations; }

 private:
  struct Shared {
    std::string text;
    std::uint32_t derivations = 0;
    CryptoKey serverKey{};  // of the last derivation
    CryptoKey key{};
  };

  std::shared_ptr<Shared> shared_;
};

/// The password in the first line of a regular file of at most 4096 bytes. Throws ProgramError (kUsage) if the file
/// cannot be read, is something else or larger, or if the line is empty.
std::string readPasswordFile(const std::string& path);

/// The server's identity in a file; creates the file, readable only by its owner, if it is missing. Throws ProgramError
/// (kUsage) if it cannot be read or holds something else, or if it cannot be created as a whole; nothing is left of it
/// then. Several servers may make the same file at once: all of them get the same identity.
ServerIdentity readKeyFile(const std::string& path);

/// Why the file of a key is not safe, with a remedy: as ssh does, if it belongs to the user of this program and others
/// may open it. Else, and without such a file, an empty text.
std::string keyFileWarning(const std::string& path);

/// Throws ProgramError (kUsage) if `readKeyFile` would, but creates no file. Returns whether there is one.
bool checkKeyFile(const std::string& path);

}  // namespace platon
