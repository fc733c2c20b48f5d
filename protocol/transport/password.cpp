#include "protocol/transport/password.h"

#include <utility>

#include "protocol/transport/server_identity.h"

namespace platon {

Password::Password(std::string text) : shared_(std::make_shared<Shared>()) { shared_->text = std::move(text); }

const CryptoKey& Password::keyFor(const CryptoKey& serverKey) const {
  if (shared_->derivations == 0 || shared_->serverKey != serverKey) {
    shared_->key = presharedKeyOf(shared_->text, serverKey);
    shared_->serverKey = serverKey;
    ++shared_->derivations;
  }
  return shared_->key;
}

}  // namespace platon
