#include "client/relayed_client.h"

#include <optional>

namespace platon {

RelayedClient::RelayedClient(const ServerAddress& server, const std::string& name, const LinkQuality& line,
                             std::uint64_t seed, Moment now, const std::optional<SessionToken>& token)
    : relay_(line.perfect() ? nullptr : std::make_unique<LossyRelay>(server, line, seed)),
      client_(server, name, now, relay_ ? std::optional(relay_->address()) : std::nullopt, token) {}

// What arrives is passed on before, what was sent after.
void RelayedClient::update(Moment now, const Controls& controls) {
  if (relay_) relay_->pump(now);
  client_.update(now, controls);
  if (relay_) relay_->pump(now);
}

}  // namespace platon
