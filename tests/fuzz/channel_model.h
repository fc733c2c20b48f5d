#pragma once

#include <cstdint>
#include <set>

#include "protocol/transport/sealed_channel.h"

namespace platon::fuzz {

/// The sender of one direction as docs/protocol.md describes it, with sequence numbers of 64 bits. Each number has one
/// content.
class ModelSender {
 public:
  ModelSender(SealedChannel::Side side, const CryptoKey& key, std::uint16_t slot);

  SealedChannel::Content content(std::uint64_t sequence) const;
  platon::Bytes datagram(std::uint64_t sequence) const;
  /// The same with any content.
  platon::Bytes seal(std::uint64_t sequence, ByteSpan content, bool isControl) const;

 private:
  SealedChannel::Side side_;
  CryptoKey key_;
  std::uint16_t slot_;
};

/// What a receiver must do with the undamaged datagram of a number: it remembers every number.
class ModelReceiver {
 public:
  /// Whether it is opened. Later ones are, unless so many were lost before that the sent bits mean another number.
  bool accepts(std::uint64_t sequence) const;
  void accept(std::uint64_t sequence);
  bool isNewest(std::uint64_t sequence) const { return sequence >= next_; }
  /// One more than the highest number that was accepted.
  std::uint64_t next() const { return next_; }

 private:
  std::set<std::uint64_t> accepted_;
  std::uint64_t next_ = 0;
};

}  // namespace platon::fuzz
