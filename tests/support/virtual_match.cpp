#include "tests/support/virtual_match.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "protocol/to_server.h"

namespace platon {

namespace {

constexpr Moment kStep = std::chrono::microseconds(500);

/// Unique per client.
SessionToken tokenOf(ClientId id) {
  SessionToken token{};
  token[0] = static_cast<std::uint8_t>(id);
  token[1] = static_cast<std::uint8_t>(id >> 8);
  return token;
}

LinkQuality delayOf(const LinkQuality& quality) {
  LinkQuality delay;
  delay.delayMs = quality.delayMs;
  return delay;
}

}  // namespace

VirtualMatch::Client::Client(ClientId number, const LinkQuality& quality, std::uint64_t seed, Controls buttons)
    : id(number),
      controls(std::move(buttons)),
      up(quality, seed),
      down(quality, seed + 1),
      reliableUp(delayOf(quality), 0),
      reliableDown(delayOf(quality), 0) {}

VirtualMatch::VirtualMatch(std::vector<std::shared_ptr<const Level>> levels, std::uint64_t seed,
                           std::uint32_t maxPlayers)
    : match_(LevelRotation(std::move(levels)), MatchSettings{maxPlayers, "test"}), seed_(seed) {
  round_ = match_.round();
}

std::size_t VirtualMatch::join(const LinkQuality& quality, Controls controls) {
  const ClientId id = nextId_++;
  clients_.push_back(std::make_unique<Client>(id, quality, seed_ + clients_.size() * 16, std::move(controls)));
  Session::Memory memory;
  memory.token = tokenOf(id);
  clients_.back()->session.emplace("someone", now_, std::move(memory));
  return clients_.size() - 1;
}

void VirtualMatch::disconnect(std::size_t index, std::optional<Moment> detectedAfter) {
  Client& client = *clients_[index];
  client.session->connectionLost("connection lost");
  client.connected = false;
  for (NetworkConditions* link : {&client.up, &client.down, &client.reliableUp, &client.reliableDown}) link->clear();
  if (detectedAfter) losses_.push_back({now_ + *detectedAfter, client.id});
}

void VirtualMatch::resume(std::size_t index) {
  Client& client = *clients_[index];
  client.id = nextId_++;
  client.connected = true;
  client.session.emplace("someone", now_, client.session->memory());
}

VirtualMatch::Client* VirtualMatch::connectedAs(ClientId id) {
  for (const auto& client : clients_) {
    if (client->id == id && client->connected) return client.get();
  }
  return nullptr;
}

void VirtualMatch::detectDisconnects() {
  std::erase_if(losses_, [this](const auto& loss) {
    if (loss.first > now_) return false;
    match_.disconnect(loss.second);
    return true;
  });
}

void VirtualMatch::tamper(std::size_t client, std::function<void(std::vector<std::uint8_t>&)> change) {
  clients_[client]->tamper = std::move(change);
}

void VirtualMatch::run(Moment duration) {
  for (const Moment end = now_ + duration; now_ < end; now_ += kStep) {
    const Moment tickDue = std::chrono::seconds(100) + Moment((serverTicks_ + 1) * 1'000'000 / kTicksPerSecond);
    if (now_ >= tickDue) tickServer();
    detectDisconnects();
    for (const auto& client : clients_) {
      if (client->connected) transfer(*client);
    }
    if (now_ < nextFrame_) continue;
    nextFrame_ = now_ + frame_;
    for (const auto& client : clients_) {
      if (!client->connected) continue;
      client->session->update(now_, client->controls);
      if (client->checked) check(*client->session);
    }
  }
}

void VirtualMatch::tickServer() {
  ++serverTicks_;
  const bool idle = match_.idle();
  if (!idle) {
    if (match_.round() != round_) {
      round_ = match_.round();
      ticksInRound_ = 0;
    }
    ++ticksInRound_;
    match_.tick();
    // The tick may have started the next round, which has had no tick yet.
    if (match_.round() == round_) hashes_[{round_, ticksInRound_}] = match_.game().hash();
  }
  for (Outgoing& message : match_.takeOutgoing()) {
    Client* const client = connectedAs(message.client);
    if (client == nullptr) continue;
    client->tamper(message.bytes);
    (message.reliable ? client->reliableDown : client->down).send(std::move(message.bytes), now_);
  }
}

void VirtualMatch::transfer(Client& client) {
  for (OutgoingMessage& message : client.session->takeOutgoing()) {
    (message.reliable ? client.reliableUp : client.up).send(std::move(message.bytes), now_);
  }
  for (NetworkConditions* link : {&client.reliableUp, &client.up}) {
    while (const auto bytes = link->receive(now_)) {
      const auto message = decodeToServer(*bytes);
      ASSERT_TRUE(message.has_value());
      match_.receive(client.id, *message);
    }
  }
  for (NetworkConditions* link : {&client.reliableDown, &client.down}) {
    while (const auto bytes = link->receive(now_)) client.session->receive(*bytes, now_);
  }
}

void VirtualMatch::check(const Session& session) const {
  ASSERT_FALSE(session.ending().has_value()) << session.ending()->reason;
  const Round* const round = session.round();
  if (round == nullptr || round->prediction().confirmedTicks() == 0) return;
  const Prediction& prediction = round->prediction();
  const auto server = hashes_.find({round->id(), prediction.confirmedTicks()});
  ASSERT_NE(server, hashes_.end()) << "round " << round->id() << " tick " << prediction.confirmedTicks();
  ASSERT_EQ(prediction.confirmed().hash(), server->second)
      << "round " << round->id() << " tick " << prediction.confirmedTicks();
}

}  // namespace platon
