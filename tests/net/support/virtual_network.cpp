#include "tests/net/support/virtual_network.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "protocol/to_server.h"

namespace platon {
namespace {

LinkQuality withoutLoss(const LinkQuality& quality) {
  LinkQuality reliable;
  reliable.delayMs = quality.delayMs;
  reliable.jitterMs = quality.jitterMs;
  return reliable;
}

}  // namespace

VirtualNetwork::Direction::Direction(const LinkQuality& quality, std::uint64_t seed)
    : unreliable_(quality, seed), reliable_(withoutLoss(quality), seed + 2) {}

void VirtualNetwork::Direction::send(Bytes bytes, bool reliable, Time now) {
  (reliable ? reliable_ : unreliable_).send(std::move(bytes), now);
}

std::optional<VirtualNetwork::Bytes> VirtualNetwork::Direction::receive(Time now) {
  if (auto bytes = reliable_.receive(now)) return bytes;
  return unreliable_.receive(now);
}

std::size_t VirtualNetwork::count(MatchEvent::Kind kind) const {
  return static_cast<std::size_t>(
      std::count_if(events_.begin(), events_.end(), [kind](const MatchEvent& event) { return event.kind == kind; }));
}

std::optional<std::uint64_t> VirtualNetwork::hashOf(std::uint32_t round, std::uint32_t tick) const {
  const auto hash = hashes_.find({round, tick});
  return hash == hashes_.end() ? std::nullopt : std::optional(hash->second);
}

bool VirtualNetwork::isLast(std::uint32_t round, std::uint32_t tick) const {
  return hashOf(round, tick - 1) && !hashOf(round, tick) && hashOf(round + 1, 0);
}

ClientId VirtualNetwork::connect(VirtualClient& client, const LinkQuality& quality) {
  const std::uint64_t seed = seed_ + lastClient_ * 16;
  connections_.emplace(++lastClient_, Connection{&client, {quality, seed}, {quality, seed + 1}});
  return lastClient_;
}

void VirtualNetwork::disconnect(ClientId client, std::optional<Time> detectedAfter) {
  connections_.erase(client);
  if (detectedAfter) losses_.push_back({now_ + *detectedAfter, client});
  detectDisconnects();
}

void VirtualNetwork::detectDisconnects() {
  std::erase_if(losses_, [this](const auto& loss) {
    if (loss.first > now_) return false;
    match_.disconnect(loss.second);
    return true;
  });
}

Time VirtualNetwork::nextTick() const { return kStart + Time((ticks_ + 1) * 1'000'000 / kTicksPerSecond); }

void VirtualNetwork::step(Time now) {
  now_ = now;
  detectDisconnects();
  for (auto& [id, connection] : connections_) {
    connection.client->update(now_);
    deliverToMatch(id, connection);
  }
  if (now_ >= nextTick()) tick();
  for (auto& [id, connection] : connections_) {
    while (auto bytes = connection.down.receive(now_)) connection.client->receive(std::move(*bytes), now_);
  }
}

void VirtualNetwork::deliverToMatch(ClientId client, Connection& connection) {
  for (OutgoingMessage& message : connection.client->takeOutgoing()) {
    connection.up.send(std::move(message.bytes), message.reliable, now_);
  }
  while (const auto bytes = connection.up.receive(now_)) {
    const auto message = decodeToServer(*bytes);
    ASSERT_TRUE(message.has_value());
    match_.receive(client, *message);
  }
}

void VirtualNetwork::tick() {
  ++ticks_;
  match_.tick();
  hashes_[{match_.round(), match_.game().tick()}] = match_.game().hash();
  for (const Outgoing& message : match_.takeOutgoing()) {
    const auto connection = connections_.find(message.client);
    if (connection == connections_.end()) continue;
    if (!message.reliable) longest_ = std::max(longest_, message.bytes.size());
    connection->second.down.send({message.bytes.begin(), message.bytes.end()}, message.reliable, now_);
  }
  for (MatchEvent& event : match_.takeEvents()) events_.push_back(std::move(event));
}

}  // namespace platon
