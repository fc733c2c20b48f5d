#include "tests/net/support/session_network.h"

#include <gtest/gtest.h>

namespace platon {
namespace {

constexpr Time kStep = std::chrono::microseconds(500);

/// Unique per client.
SessionToken tokenOf(std::size_t client) {
  SessionToken token{};
  token[0] = static_cast<std::uint8_t>(client);
  token[1] = static_cast<std::uint8_t>(client >> 8);
  return token;
}

}  // namespace

SessionNetwork::SessionNetwork(std::vector<std::shared_ptr<const Level>> levels, std::uint64_t seed,
                               std::uint32_t maxPlayers, MatchProgram program)
    : VirtualNetwork(Match(LevelRotation(std::move(levels)), MatchSettings{maxPlayers, "test"}, std::move(program)),
                     seed) {}

std::size_t SessionNetwork::join(const LinkQuality& quality, Controls controls,
                                 std::shared_ptr<ConfirmedObserver> observer) {
  Session::Memory memory;
  memory.observer = std::move(observer);
  memory.token = tokenOf(clients_.size());
  Client& client = *clients_.emplace_back(std::make_unique<Client>(*this, quality, std::move(controls)));
  client.session.emplace("someone", now(), std::move(memory));
  client.id = connect(client, quality);
  return clients_.size() - 1;
}

void SessionNetwork::disconnect(std::size_t index, std::optional<Time> detectedAfter) {
  Client& client = *clients_[index];
  client.session->connectionLost("connection lost");
  VirtualNetwork::disconnect(client.id, detectedAfter);
}

void SessionNetwork::resume(std::size_t index) {
  Client& client = *clients_[index];
  client.session.emplace("someone", now(), client.session->memory());
  client.id = connect(client, client.quality);
}

void SessionNetwork::run(Time duration) {
  for (const Time end = now() + duration; now() < end;) step(now() + kStep);
}

void SessionNetwork::Client::receive(std::vector<std::uint8_t> bytes, Time now) {
  tamper(bytes);
  session->receive(bytes, now);
}

void SessionNetwork::Client::update(Time now) {
  if (now < nextUpdate) return;
  nextUpdate = now + network.frame_;
  session->update(now, controls);
  if (checked) expectInLockstep();
}

void SessionNetwork::Client::expectInLockstep() const {
  ASSERT_FALSE(session->ending().has_value()) << session->ending()->reason;
  const Round* const round = session->round();
  if (round == nullptr) return;
  const Prediction& prediction = round->prediction();
  const std::uint32_t tick = prediction.confirmedTicks();
  if (tick == 0 || network.isLast(round->id(), tick)) return;
  ASSERT_EQ(prediction.confirmed().hash(), network.hashOf(round->id(), tick))
      << "round " << round->id() << " tick " << tick;
}

}  // namespace platon
