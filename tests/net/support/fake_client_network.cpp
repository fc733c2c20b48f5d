#include "tests/net/support/fake_client_network.h"

#include <utility>

namespace platon {

FakeClient& FakeClientNetwork::add(FakeClient client) {
  FakeClient& added = clients_.emplace_back(std::move(client));
  connect(added, quality_);
  return added;
}

void FakeClientNetwork::leave(ClientId client) {
  match().receive(client, Leave{});
  disconnect(client);
}

void FakeClientNetwork::run(std::uint32_t ticks) {
  for (std::uint32_t i = 0; i < ticks; ++i) tick();
}

}  // namespace platon
