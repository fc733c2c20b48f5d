#pragma once

#include <cstring>
#include <set>
#include <utility>

#include "protocol/moment.h"
#include "protocol/transport/noise.h"

namespace platon {

/// The ephemeral keys of an epoch and of the one before, so that a recorded handshake cannot be repeated while its
/// cookie is valid. The epochs are those of CookieJar. The caller limits how many keys are added in a second.
class RecentKeys {
 public:
  explicit RecentKeys(Moment epoch) : epoch_(epoch) {}

  bool contains(const CryptoKey& key, Moment now) {
    forget(now);
    return present_.contains(printOf(key)) || former_.contains(printOf(key));
  }

  void add(const CryptoKey& key, Moment now) {
    forget(now);
    present_.insert(printOf(key));
  }

 private:
  // The keys are random, so 8 bytes of one identify it. Clients choose them: in a hash table they could all collide.
  using Prints = std::set<std::uint64_t>;

  static std::uint64_t printOf(const CryptoKey& key) {
    std::uint64_t print;
    std::memcpy(&print, key.data(), sizeof print);
    return print;
  }

  void forget(Moment now) {
    const std::int64_t number = now / epoch_;
    if (number == number_) return;
    former_ = number == number_ + 1 ? std::move(present_) : Prints();
    present_.clear();
    number_ = number;
  }

  Moment epoch_;
  std::int64_t number_ = 0;  // of the present epoch
  Prints present_;
  Prints former_;
};

}  // namespace platon
