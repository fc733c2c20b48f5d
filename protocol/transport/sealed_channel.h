#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <optional>

#include "protocol/transport/noise.h"

namespace platon {

/// Remembers which of the last sequence numbers have arrived.
class ReplayWindow {
 public:
  static constexpr std::uint64_t kSize = 512;

  /// Whether this number is newer than the window, or within it and has not arrived.
  bool isFresh(std::uint64_t sequence) const;
  /// Marks a fresh number as arrived.
  void mark(std::uint64_t sequence);
  /// One more than the highest number that has arrived.
  std::uint64_t next() const { return next_; }

 private:
  std::bitset<kSize> arrived_;  // by sequence number modulo kSize
  std::uint64_t next_ = 0;
};

/// One end of a session's two directions. Every datagram is sealed whole: ChaCha20-Poly1305 with its 64-bit sequence
/// number as nonce, of which 14 bits are sent. The order of sealing and opening does not matter; a datagram is opened
/// once. It has no socket and no clock, and forgets the keys at its end.
///
/// Layout: two bytes: 1, whether it is for the transport itself, 14 bits of the sequence number, most significant
/// first; to the server: slot, two bytes, least significant first; then ciphertext and tag. The bytes before the
/// ciphertext are authenticated.
class SealedChannel {
 public:
  enum class Side { kServer, kClient };
  /// Largest number of bytes that a datagram has more than its content.
  static constexpr std::size_t kOverhead = 2 + 2 + kTagBytes;

  /// What was sealed in a datagram.
  struct Content {
    Bytes bytes;
    bool isControl = false;  ///< for the transport itself
    bool isNewest = false;   ///< no datagram sealed later has arrived
  };

  SealedChannel(Side side, const SessionKeys& keys, std::uint16_t slot);

  Bytes seal(ByteSpan content, bool isControl = false);
  /// Nothing if the datagram is damaged, forged, or arrived before.
  std::optional<Content> open(ByteSpan datagram);

  /// Whether a datagram has the form of a sealed one.
  static bool isSealed(ByteSpan datagram);
  /// The slot in a sealed datagram to the server; nothing if it is too short.
  static std::optional<std::uint16_t> slotOf(ByteSpan datagram);

 private:
  std::size_t headBytes(Side sender) const { return sender == Side::kClient ? 4 : 2; }
  const CryptoKey& sendKey() const { return side_ == Side::kServer ? keys_.toClient : keys_.toServer; }
  const CryptoKey& receiveKey() const { return side_ == Side::kServer ? keys_.toServer : keys_.toClient; }
  std::uint64_t expand(std::uint16_t low) const;

  Side side_;
  SessionKeys keys_;
  std::uint16_t slot_;
  std::uint64_t sent_ = 0;
  ReplayWindow received_;
};

/// Content of a sealed datagram for the transport itself: one of these bytes, then a challenge.
inline constexpr std::uint8_t kPathChallenge = 1;  ///< server: shows whether the client receives at its new address
inline constexpr std::uint8_t kPathResponse = 2;   ///< client: the challenge it has received

using PathChallenge = std::array<std::uint8_t, 8>;

/// Bytes of the datagram with a challenge.
inline constexpr std::size_t kPathChallengeBytes = 2 + 1 + sizeof(PathChallenge) + kTagBytes;

}  // namespace platon
