#include "client/local/local_server.h"

#include <cassert>
#include <utility>

namespace platon {

// Each message is delivered before the server's end is noticed.
void LocalLink::service(Time /*now*/, const Receiver& receiver) {
  for (const std::vector<std::uint8_t>& message : std::exchange(way_->toClient, {})) receiver(message);
  isClosed_ = isClosed_ || way_->serverEnds;
}

void LocalLink::send(std::span<const std::uint8_t> message, bool /*reliable*/) {
  if (!isClosed_ && !way_->clientEnds) way_->toServer.emplace_back(message.begin(), message.end());
}

LocalServer::LocalServer(const MatchSettings& settings, std::vector<LevelPointer> levels, BestTimeKeeper* times,
                         Time now)
    : match_(LevelRotation(std::move(levels), LevelRotation::Start::kFirst), settings, {.bestTimes = times}),
      clock_(TimePoint(now)) {}

ServerLinks LocalServer::links() {
  return {"this program", [this](const ServerKnowledge&) {
            const auto way = std::make_shared<LocalLink::Way>();
            ways_.emplace(++last_, way);
            return std::make_unique<LocalLink>(way);
          }};
}

void LocalServer::update(Time now) {
  const bool wasIdle = match_.idle();
  receive();
  if (wasIdle)
    clock_ = TickClock(TimePoint(now));
  else
    while (clock_.take(TimePoint(now))) match_.tick();
  send();
  match_.takeEvents();  // nobody keeps a log
}

void LocalServer::receive() {
  for (auto& [client, way] : ways_) {
    for (const std::vector<std::uint8_t>& bytes : std::exchange(way->toServer, {})) {
      const std::optional<ToServer> message = decodeToServer(bytes);
      assert(message && "a client in this program sends what it encodes");
      if (message) match_.receive(client, *message);
    }
    if (way->clientEnds) match_.disconnect(client);
    way->serverEnds = way->serverEnds || way->clientEnds;
  }
  std::erase_if(ways_, [](const auto& entry) { return entry.second->serverEnds; });
}

void LocalServer::send() {
  for (const Outgoing& message : match_.takeOutgoing()) {
    const auto found = ways_.find(message.client);
    if (found == ways_.end()) continue;
    found->second->toClient.emplace_back(message.bytes.begin(), message.bytes.end());
    found->second->serverEnds = found->second->serverEnds || message.last;
  }
}

}  // namespace platon
