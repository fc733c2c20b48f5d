#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <utility>

#include "protocol/transport/datagram_socket.h"
#include "protocol/transport/handshake.h"
#include "tests/net/attacks/attack_addresses.h"

namespace platon {

/// A datagram between a victim and the server.
struct Overheard {
  SocketAddress victim;
  bool toServer = false;
  Bytes bytes;
};

/// Bytes that passed between an attacker and the server.
struct Exchange {
  std::uint64_t sent = 0;      ///< by the attacker
  std::uint64_t received = 0;  ///< by the attacker, and by those in whose names he sends, the victims aside
  std::uint64_t ticks = 0;     ///< of what he received: for the ticks, which every player is sent

  friend Exchange operator-(const Exchange& a, const Exchange& b) {
    return {a.sent - b.sent, a.received - b.received, a.ticks - b.ticks};
  }
};

/// The network before a server, as an attacker has it: he sends in anybody's name, receives at his own addresses, and
/// reads all that passes between the server and its honest players, the victims.
class AttackNetwork {
 public:
  /// Largest number of datagrams that are remembered.
  static constexpr std::size_t kMaxOverheard = 1000;
  static constexpr std::size_t kMaxHandshakes = 64;

  virtual ~AttackNetwork() = default;

  /// Sends a datagram to the server in the name of `from`, which is anybody's.
  virtual void send(const SocketAddress& from, ByteSpan datagram) = 0;
  /// A socket at an address of the attacker's own, for what needs answers. The network must outlive it.
  virtual std::unique_ptr<DatagramSocket> socket(const IpAddress& own) = 0;
  virtual SocketAddress server() const = 0;
  IpVersion version() const { return server().ip.isIpv4() ? IpVersion::kIpv4 : IpVersion::kIpv6; }
  /// The last datagrams of the victims, oldest first.
  const std::deque<Overheard>& overheard() const { return overheard_; }
  /// Calls this with each datagram of a victim, before it is delivered. Empty: nothing.
  void setEar(std::function<void(const Overheard&)> ear) { ear_ = std::move(ear); }
  const Exchange& exchange() const { return exchange_; }
  /// An attacker calls this for what he has received.
  void noteTicks(std::size_t bytes) { exchange_.ticks += bytes; }
  /// Those of them that open a session, from the beginning.
  const std::deque<Overheard>& opens() const { return opens_; }

 protected:
  void noteSent(std::size_t bytes) { exchange_.sent += bytes; }
  void noteReceived(std::size_t bytes) { exchange_.received += bytes; }
  void note(const SocketAddress& victim, bool toServer, ByteSpan bytes) {
    const bool isOpen = toServer && decodeOpen(bytes);
    if (isOpen && opens_.size() < kMaxHandshakes) opens_.push_back({victim, true, {bytes.begin(), bytes.end()}});
    if (overheard_.size() == kMaxOverheard) overheard_.pop_front();
    overheard_.push_back({victim, toServer, {bytes.begin(), bytes.end()}});
    if (ear_) ear_(overheard_.back());
  }

 private:
  std::function<void(const Overheard&)> ear_;
  std::deque<Overheard> overheard_;
  Exchange exchange_;
  std::deque<Overheard> opens_;
};

}  // namespace platon
