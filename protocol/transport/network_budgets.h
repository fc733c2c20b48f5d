#pragma once

#include <sodium.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>
#include <vector>

#include "protocol/token_bucket.h"
#include "protocol/transport/noise.h"

namespace platon {

/// A budget for each of any number of networks, in little memory. Each draws on two of kBuckets buckets, by a keyed
/// hash: a newcomer may share one with an attacker, but hardly both, and nobody can tell with whom.
class NetworkBudgets {
 public:
  static constexpr std::size_t kBuckets = 1024;

  /// Every budget starts full. Who does not know the key cannot tell which networks share a bucket.
  NetworkBudgets(double perSecond, double limit, const CryptoKey& key, Moment now)
      : buckets_(kBuckets, TokenBucket(perSecond, limit, now)), key_(key) {}

  /// Takes 1 from both buckets of the network. False if neither holds it.
  bool take(std::uint64_t network, Moment now) {
    const auto [first, second] = bucketsOf(network);
    const bool isWithin = first->take(1, now);
    return (second != first && second->take(1, now)) || isWithin;
  }

  /// Whether `take` would succeed.
  bool holds(std::uint64_t network, Moment now) {
    const auto [first, second] = bucketsOf(network);
    return TokenBucket(*first).take(1, now) || TokenBucket(*second).take(1, now);
  }

 private:
  std::pair<TokenBucket*, TokenBucket*> bucketsOf(std::uint64_t network) {
    const std::uint64_t hash = hashOf(network);
    return {&buckets_[hash % kBuckets], &buckets_[(hash >> 32) % kBuckets]};
  }
  std::uint64_t hashOf(std::uint64_t network) const {
    static_assert(sizeof key_ >= crypto_shorthash_KEYBYTES && crypto_shorthash_BYTES == sizeof network);
    std::array<std::uint8_t, sizeof network> bytes;
    std::memcpy(bytes.data(), &network, sizeof network);
    std::array<std::uint8_t, sizeof network> hashed;
    crypto_shorthash(hashed.data(), bytes.data(), bytes.size(), key_.data());
    std::uint64_t hash = 0;
    std::memcpy(&hash, hashed.data(), sizeof hash);
    return hash;
  }

  std::vector<TokenBucket> buckets_;
  CryptoKey key_;
};

}  // namespace platon
