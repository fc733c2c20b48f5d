#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "client/net/enet_link.h"
#include "client/session/session.h"
#include "tests/net/soak/input_check.h"
#include "tests/net/soak/soak_client.h"
#include "tests/net/support/datagram_network.h"

namespace platon {

/// What bots have done.
struct SoakCounts {
  std::uint64_t joins = 0;    ///< as new players
  std::uint64_t resumes = 0;  ///< of their players
  std::uint64_t leaves = 0;
  std::uint64_t drops = 0;  ///< lost connections

  SoakCounts& operator+=(const SoakCounts& other) {
    joins += other.joins;
    resumes += other.resumes;
    leaves += other.leaves;
    drops += other.drops;
    return *this;
  }
};

/// A player that comes and goes, as its seed says.
class SoakBot {
 public:
  /// What all bots are told to do.
  enum class Order {
    kRoam,    ///< come, play, leave, lose the connection, resume
    kGather,  ///< come, and stay
    kLeave,   ///< leave, and stay away
  };
  /// How a bot plays.
  struct Kind {
    bool isHollow = true;      ///< a HollowSession, otherwise a Session
    bool isRestless = false;   ///< changes its buttons in every tick
    bool isPermanent = false;  ///< leaves only on Order::kLeave
    double loss = 0;           ///< share of its datagrams that are lost, each way
  };

  /// `number`: 1 … 254, the last byte of its address.
  SoakBot(DatagramNetwork& network, const SocketAddress& server, std::uint8_t number, const Kind& kind);

  void update(Time now, Order order);

  /// Whether a datagram from or to this address of the bot is delivered.
  bool passes(const SocketAddress& own);

  /// Of its player, while it plays or can resume it.
  std::optional<std::uint32_t> slot() const { return slot_; }
  const Kind& kind() const { return kind_; }
  /// Whether the server should know it as a connected player that sends its inputs.
  bool isPlaying() const { return client_ != nullptr && client_->confirmedTicks() > 0 && !leaving_; }
  /// Call when the server has decided a tick of a player that is in this slot. Returns whether it was decided without
  /// the input that the bot has sent for it.
  bool misses(std::uint32_t round, std::uint32_t tick, std::uint8_t buttons) {
    return inputs_.decided(round, tick, buttons);
  }
  /// Of all its sessions; 0 for a bot without a game.
  std::uint64_t desyncs() const;
  std::uint64_t corrections() const;
  const SoakCounts& counts() const { return counts_; }
  /// Datagrams of its longest connection.
  Traffic longestTraffic() const;
  /// What went wrong; at most kMaxFaults.
  const std::vector<std::string>& faults() const { return faults_; }

 private:
  static constexpr std::size_t kMaxFaults = 4;

  void connect(Time now);
  void exchange(Time now);
  void send(const OutgoingMessage& message);
  void startSession(Time now);
  void noteJoined();
  void checkSession(Time now);
  void depart(Time now, bool politely);
  void drop(Time now);
  void leave(Time now);
  void forget();
  void fault(const std::string& what);
  Time between(int lowSeconds, int highSeconds);

  DatagramNetwork& network_;
  SocketAddress server_;
  std::uint8_t number_;
  Kind kind_;
  std::string name_;
  std::mt19937_64 random_;
  SoakMemory memory_;
  std::uint16_t connections_ = 0;  // so far
  std::optional<EnetLink> connection_;
  std::unique_ptr<SoakClient> client_;  // of connection_, once it is connected
  InputCheck inputs_;                   // of client_
  bool leaving_ = false;
  bool hasJoined_ = false;             // in this session
  std::optional<std::uint32_t> slot_;  // of the player to resume
  Time resumableUntil_{};
  Time since_{};     // when it began to connect
  Time nextMove_{};  // when it comes or goes
  SoakCounts counts_;
  Traffic longestTraffic_;
  std::vector<std::string> faults_;
};

/// The one with more datagrams.
Traffic longer(const Traffic& a, const Traffic& b);

}  // namespace platon
