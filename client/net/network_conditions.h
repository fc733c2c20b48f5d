#pragma once

#include <netinet/in.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <random>
#include <vector>

#include "protocol/time.h"
#include "protocol/transport/server_address.h"

namespace platon {

/// Quality of one direction of a simulated connection. The default is a perfect connection.
struct LinkQuality {
  double lossPercent = 0;         ///< datagrams lost independently of each other, 0 … 100
  double burstLossPercent = 0;    ///< datagrams lost in bursts, 0 … 100, in addition to lossPercent
  double burstLength = 4;         ///< mean number of datagrams in a burst, at least 1; see NetworkConditions
  double delayMs = 0;             ///< delay of every datagram
  double jitterMs = 0;            ///< additional delay, uniform from 0 to this value; keeps the order
  double duplicatePercent = 0;    ///< datagrams delivered twice
  double reorderPercent = 0;      ///< datagrams delayed by kReorderDelay, so that later ones overtake them
  double kilobytesPerSecond = 0;  ///< bandwidth, UDP payload, 1000 bytes each; 0: unlimited, else at least 0.001
  double corruptPercent = 0;      ///< datagrams delivered with one bit flipped

  bool perfect() const;
};

/// One direction of a simulated connection. Datagrams may be delayed, lost, duplicated, reordered or corrupted. The
/// same seed, datagrams and times give the same deliveries on every platform. Burst loss and corruption consume no
/// random numbers while their percentages are 0.
///
/// Bandwidth: a datagram of n bytes occupies the connection for n / kilobytesPerSecond, in the order of sending;
/// datagrams that are lost afterwards occupy it too. A datagram that would have to wait longer than kMaxQueueTime is
/// dropped. Delay and jitter start when a datagram has passed this bottleneck.
///
/// Burst loss (Gilbert's model): the connection is in one of two states, which may change before each datagram; within
/// a burst all are lost. With share s and mean burst length L, a burst ends with probability 1 / L and starts with
/// probability s / (L (1 − s)), so that a share s of all datagrams is lost. If L < s / (1 − s), where bursts would
/// have to overlap, the mean length is s / (1 − s) instead.
///
/// Corruption: drawn for each copy of a duplicated datagram.
class NetworkConditions {
 public:
  static constexpr Time kReorderDelay = std::chrono::milliseconds(40);
  static constexpr Time kMaxQueueTime = std::chrono::milliseconds(250);

  NetworkConditions(const LinkQuality& quality, std::uint64_t seed) : quality_(quality), random_(seed) {}

  /// Sends a datagram at `now`, which never decreases.
  void send(std::vector<std::uint8_t> datagram, Time now);
  /// Returns the next datagram that has arrived by `now`; nothing if there is none.
  std::optional<std::vector<std::uint8_t>> receive(Time now);
  /// Applies to datagrams sent from now on.
  void setQuality(const LinkQuality& quality) { quality_ = quality; }
  /// Drops all datagrams in flight.
  void clear() { inFlight_.clear(); }
  /// Number of datagrams in flight.
  std::size_t pending() const { return inFlight_.size(); }

 private:
  struct InFlight {
    Time due;
    std::vector<std::uint8_t> datagram;
  };

  double draw() { return static_cast<double>(random_() >> 11) * 0x1p-53; }
  bool chance(double percent) { return draw() * 100 < percent; }
  std::optional<Time> passBottleneck(std::size_t bytes, Time now);
  bool drawBurst();
  Time dueTime(Time now);
  void deliverAt(std::vector<std::uint8_t> datagram, Time due);
  void corrupt(std::vector<std::uint8_t>& datagram);

  LinkQuality quality_;
  std::mt19937_64 random_;
  Time freeAt_{};         // when the bottleneck is free
  bool inBurst_ = false;  // whether the last datagram was in a burst
  Time lastDue_{};
  std::vector<InFlight> inFlight_;  // by due time; equal due times in the order of sending
};

/// Forwards UDP datagrams between one local client and a server under simulated network conditions, both ways. The
/// conditions affect every datagram: handshakes, acknowledgements and retransmissions too. A client that reconnects
/// from another port gets another port towards the server, as behind a NAT router.
class LossyRelay {
 public:
  /// Opens two sockets. Throws std::runtime_error if the host name cannot be resolved or no socket is available.
  /// `eachWay`: the conditions in each direction; the random numbers of both are derived from `seed`.
  LossyRelay(const ServerAddress& server, const LinkQuality& eachWay, std::uint64_t seed);

  /// The address to which the client has to connect.
  ServerAddress address() const { return {"127.0.0.1", port_}; }

  /// Applies to datagrams received from now on.
  void setQuality(const LinkQuality& eachWay);
  /// Receives datagrams and forwards those that are due at `now`. Call every few milliseconds.
  void pump(Time now);

 private:
  struct Socket {
    Socket();
    ~Socket();
    Socket(const Socket&) = delete;
    Socket& operator=(const Socket&) = delete;
    int handle;
  };

  bool connectToServer() const;
  void setClient(const sockaddr_in& client);
  void receiveFromClient(Time now);
  void receiveFromServer(Time now);

  sockaddr_in server_;
  Socket clientSide_;
  std::optional<Socket> serverSide_;
  std::uint16_t port_ = 0;
  sockaddr_in client_{};  // port 0 until the client has sent a datagram
  NetworkConditions up_;
  NetworkConditions down_;
};

/// A bot's route to the server: direct, or through a relay of its own that simulates network conditions.
class ServerRoute {
 public:
  /// Uses a relay unless `quality` is perfect. `seed`: of the relay's random numbers. Throws std::runtime_error as
  /// LossyRelay does.
  ServerRoute(const ServerAddress& server, const LinkQuality& quality, std::uint64_t seed) : server_(server) {
    if (!quality.perfect()) relay_.emplace(server, quality, seed);
  }

  /// The address to connect to.
  ServerAddress address() const { return relay_ ? relay_->address() : server_; }
  /// Forwards datagrams. Call before the bot receives and after it has sent.
  void pump(Time now) {
    if (relay_) relay_->pump(now);
  }

 private:
  ServerAddress server_;
  std::optional<LossyRelay> relay_;
};

}  // namespace platon
