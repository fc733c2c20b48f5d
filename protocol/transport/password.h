#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "protocol/transport/noise.h"

namespace platon {

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

}  // namespace platon
