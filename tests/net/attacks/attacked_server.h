#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "server/app/dedicated_server.h"
#include "tests/net/attacks/buffered_socket.h"
#include "tests/net/attacks/heap_bytes.h"
#include "tests/net/support/datagram_network.h"

namespace platon {

/// A server in a simulated network, in virtual time. It measures its own memory, and counts the bytes that it sends.
class AttackedServer {
 public:
  static constexpr std::uint32_t kMaxPlayers = 64;
  static constexpr std::uint32_t kPlayersPerAddress = 4;

  /// Plays a long level.
  AttackedServer(DatagramNetwork& network, const SocketAddress& own, const std::string& password);
  AttackedServer(DatagramNetwork& network, const SocketAddress& own, const ServerSettings& settings,
                 std::vector<LevelPointer> levels, Log log);

  /// Runs one tick.
  void tick(Time now);
  /// Changes the server as its operator can.
  template <class Change>
  void change(Change change) {
    const HeapGauge gauge(heap_);
    change(server_);
  }

  const DedicatedServer& server() const { return server_; }
  /// Bytes that the server has allocated and not released since the last resetHeap.
  std::int64_t heapGrowth() const { return heap_; }
  void resetHeap() { heap_ = 0; }
  std::uint64_t bytesTo(const SocketAddress& receiver) const;

 private:
  AttackedServer(std::unique_ptr<BufferedSocket> socket, const ServerSettings& settings,
                 std::vector<LevelPointer> levels, Log log);

  BufferedSocket* socket_;  // server_ owns it
  DedicatedServer server_;
  std::int64_t heap_ = 0;
  std::map<SocketAddress, std::uint64_t> bytesTo_;
};

}  // namespace platon
