#pragma once

#include <algorithm>
#include <cstring>
#include <vector>

#include "protocol/moment.h"
#include "protocol/transport/noise.h"

namespace platon {

/// The ephemeral keys that were used lately, so that a recorded handshake cannot be repeated while its cookie is valid.
/// When it is full, the oldest is forgotten.
class RecentKeys {
 public:
  RecentKeys(std::size_t capacity, Moment lifetime) : capacity_(capacity), lifetime_(lifetime) {}

  bool contains(const CryptoKey& key, Moment now) const {
    return std::any_of(uses_.begin(), uses_.end(),
                       [&](const Use& use) { return use.print == printOf(key) && now - use.at < lifetime_; });
  }

  void add(const CryptoKey& key, Moment now) {
    if (uses_.size() < capacity_) {
      uses_.push_back({printOf(key), now});
      return;
    }
    uses_[next_] = {printOf(key), now};
    next_ = (next_ + 1) % capacity_;
  }

 private:
  struct Use {
    std::uint64_t print;
    Moment at;
  };

  // The keys are random, so 8 bytes of one identify it.
  static std::uint64_t printOf(const CryptoKey& key) {
    std::uint64_t print;
    std::memcpy(&print, key.data(), sizeof print);
    return print;
  }

  std::size_t capacity_;
  Moment lifetime_;
  std::vector<Use> uses_;
  std::size_t next_ = 0;  // the oldest, once full
};

}  // namespace platon
