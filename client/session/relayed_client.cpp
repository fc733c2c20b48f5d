#include "client/session/relayed_client.h"

namespace platon {

RelayedClient::RelayedClient(const ServerAddress& server, const std::string& name, const LinkQuality& line,
                             std::uint64_t seed, Moment now, const std::optional<SessionToken>& token)
    : line_(server, line, seed), client_(server, name, now, line_.address(), token) {}

void RelayedClient::update(Moment now, const Controls& controls) {
  line_.pump(now);
  client_.update(now, controls);
  line_.pump(now);
}

}  // namespace platon
