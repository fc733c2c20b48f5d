#pragma once

#include <cstdint>
#include <deque>

#include "client/hud/net_graph.h"
#include "client/session/network_client.h"
#include "protocol/moment.h"

namespace platon {

/// Samples the state of a connection, and how often pictures are drawn, for the net graph.
class NetMeter {
 public:
  /// Call once per frame. `now` goes on also while the game is paused. Rates are averages over the last second. The
  /// client must have a session.
  NetSample sample(const NetworkClient& client, Moment now);

 private:
  struct Reading {
    Moment at;
    Traffic traffic;  // total
  };

  std::deque<Reading> readings_;  // of the last second, oldest first
  std::uint32_t corrections_ = 0;
};

}  // namespace platon
