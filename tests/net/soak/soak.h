#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "tests/net/attacks/attacked_server.h"
#include "tests/net/soak/soak_bot.h"
#include "tests/net/support/datagram_network.h"

namespace platon {

/// What happens in a soak, one after the other.
struct SoakPlan {
  Time shortRounds;  ///< the operator ends each round after some seconds
  Time idle;         ///< all players leave
  Time longRounds;   ///< rounds end by themselves, after five minutes at most
  Time rollCall;     ///< time from one roll call to the next: all players come, stay for some seconds, and are counted

  Time idleEnd() const { return shortRounds + idle; }
  Time length() const { return shortRounds + idle + longRounds; }
};

/// What a soak has shown.
struct SoakReport {
  Time simulated{};
  std::uint64_t ticks = 0;
  std::uint64_t rounds = 0;
  std::uint32_t longestRound = 0;  ///< ticks
  SoakCounts counts;
  std::uint64_t datagrams = 0;
  Traffic longestTraffic;  ///< of one connection
  std::uint64_t rollCalls = 0;
  std::uint64_t absent = 0;        ///< players that were not there at a roll call
  std::uint64_t desyncs = 0;       ///< that the server or a client has seen
  std::uint64_t missedInputs = 0;  ///< of players without loss: ticks decided with other buttons than they sent
  std::uint64_t corrections = 0;   ///< of the permanent player with a game
  std::int64_t serverGrowth = 0;   ///< most bytes that the server had more at a roll call than at the first
  std::int64_t lastGrowth = 0;     ///< the same at the last roll call
  std::int64_t processGrowth = 0;  ///< the same of the whole process
  std::int64_t idleGrowth = 0;     ///< bytes that the server without players had more than before the first one
  std::map<std::string, std::uint64_t> rejected;  ///< datagrams and connections, by reason
  std::vector<std::string> warnings;              ///< of the server's log, and faults of the bots; the first ones

  std::string text() const;
};

/// A server with 32 bots without a game and two with one, in virtual time.
class Soak {
 public:
  explicit Soak(const SoakPlan& plan);

  /// Calls `note` with what has been seen so far after each simulated hour.
  SoakReport run(const std::function<void(const SoakReport&)>& note);

 private:
  bool deliver(const DatagramNetwork::Sent& datagram);
  void step();
  void endRounds();
  void countMissedInputs();
  void callRoll();
  void callEmpty();
  bool isIdle() const;
  SoakBot::Order orderNow() const;
  void complete();
  void warn(const std::string& text);

  SoakPlan plan_;
  DatagramNetwork network_;
  std::vector<std::unique_ptr<SoakBot>> bots_;
  Time start_;
  Time elapsed_{};
  std::int64_t steps_ = 0;
  std::unique_ptr<AttackedServer> server_;
  std::mt19937_64 random_{1};
  Time nextRound_{};                        // when the operator ends one
  std::uint32_t lastTick_ = 0;              // of the game
  std::optional<std::int64_t> serverHeap_;  // at the first roll call
  std::int64_t processHeap_ = 0;
  SoakReport report_;
};

}  // namespace platon
