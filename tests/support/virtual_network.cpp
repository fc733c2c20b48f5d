#include "tests/support/virtual_network.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace platon {

FakeClient& VirtualNetwork::add(FakeClient client) {
  links_.emplace_back();
  links_.back().client = std::make_unique<FakeClient>(std::move(client));
  return *links_.back().client;
}

void VirtualNetwork::disconnect(ClientId client) {
  links_[client - 1].connected = false;
  match_.disconnect(client);
}

void VirtualNetwork::leave(ClientId client) {
  match_.receive(client, Leave{});
  disconnect(client);
}

void VirtualNetwork::run(std::uint32_t ticks) {
  for (std::uint32_t i = 0; i < ticks; ++i) tick();
}

void VirtualNetwork::tick() {
  ++now_;
  for (Link& link : links_) {
    if (!link.connected) continue;
    for (Bytes& bytes : link.client->takeReliable()) post(link.up, std::move(bytes));
    if (auto bytes = link.client->inputs()) post(link.upUnsequenced, std::move(*bytes));
  }
  deliverToMatch();
  match_.tick();
  hashes_[{match_.round(), match_.game().tick()}] = match_.game().hash();
  deliverToClients();
}

void VirtualNetwork::deliverToMatch() {
  for (std::size_t i = 0; i < links_.size(); ++i) {
    if (!links_[i].connected) continue;
    receive(links_[i].up, links_[i].upUnsequenced, [this, i](const Bytes& bytes) {
      const auto message = decodeToServer(bytes);
      ASSERT_TRUE(message);
      match_.receive(static_cast<ClientId>(i + 1), *message);
    });
  }
}

void VirtualNetwork::deliverToClients() {
  for (Outgoing& message : match_.takeOutgoing()) {
    Link& link = links_[message.client - 1];
    if (!message.reliable) {
      longest_ = std::max(longest_, message.bytes.size());
      post(link.downUnsequenced, std::move(message.bytes));
    } else {
      post(link.down, std::move(message.bytes));
    }
  }
  for (MatchEvent& event : match_.takeEvents()) events_.push_back(std::move(event));
  for (Link& link : links_) {
    if (!link.connected) continue;
    receive(link.down, link.downUnsequenced, [&link](const Bytes& bytes) { link.client->receive(bytes); });
  }
}

std::uint64_t VirtualNetwork::arrival() {
  return now_ + conditions_.delay + (conditions_.jitter == 0 ? 0 : random_() % (conditions_.jitter + 1));
}

void VirtualNetwork::post(std::deque<Parcel>& queue, Bytes bytes) { queue.push_back({arrival(), std::move(bytes)}); }

void VirtualNetwork::post(std::vector<Parcel>& queue, Bytes bytes) {
  if (static_cast<double>(random_() % 1000) < conditions_.loss * 1000) return;
  queue.push_back({arrival(), std::move(bytes)});
}

template <class Take>
void VirtualNetwork::receive(std::deque<Parcel>& queue, std::vector<Parcel>& unsequenced, Take take) {
  for (; !queue.empty() && queue.front().due <= now_; queue.pop_front()) take(queue.front().bytes);
  const auto due =
      std::partition(unsequenced.begin(), unsequenced.end(), [this](const Parcel& p) { return p.due > now_; });
  for (auto parcel = due; parcel != unsequenced.end(); ++parcel) take(parcel->bytes);
  unsequenced.erase(due, unsequenced.end());
}

std::size_t VirtualNetwork::count(MatchEvent::Kind kind) const {
  return static_cast<std::size_t>(
      std::count_if(events_.begin(), events_.end(), [kind](const MatchEvent& event) { return event.kind == kind; }));
}

}  // namespace platon
