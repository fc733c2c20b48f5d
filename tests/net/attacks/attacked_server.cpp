#include "tests/net/attacks/attacked_server.h"

#include "tests/support/test_levels.h"

namespace platon {
namespace {

ServerSettings settingsOf(const std::string& password) {
  ServerSettings settings;
  settings.password = password;
  settings.playersPerAddress = AttackedServer::kPlayersPerAddress;
  settings.match.maxPlayers = AttackedServer::kMaxPlayers;
  return settings;
}

// So long that clients who acknowledge nothing make the server keep something.
LevelPointer longLevel() {
  constexpr int kLines = 1000;
  std::string text(endlessLevel()->text);
  for (int i = 0; i < kLines; ++i) text += "# A line of 64 bytes that says nothing. A line that says nothing.\n";
  return loadLevel(text).level;
}

Log silentLog() {
  return {LogFormat::kText, [](std::string_view) {}};
}

}  // namespace

AttackedServer::AttackedServer(DatagramNetwork& network, const SocketAddress& own, const std::string& password)
    : AttackedServer(network, own, settingsOf(password), {longLevel()}, silentLog()) {}

AttackedServer::AttackedServer(DatagramNetwork& network, const SocketAddress& own, const ServerSettings& settings,
                               std::vector<LevelPointer> levels, Log log)
    : AttackedServer(std::make_unique<BufferedSocket>(network.socket(own)), settings, std::move(levels),
                     std::move(log)) {}

AttackedServer::AttackedServer(std::unique_ptr<BufferedSocket> socket, const ServerSettings& settings,
                               std::vector<LevelPointer> levels, Log log)
    : socket_(socket.get()), server_(std::move(socket), settings, std::move(levels), std::move(log)) {}

void AttackedServer::tick(Time now) {
  socket_->fetch(now);
  {
    const HeapGauge gauge(heap_);
    server_.step(TimePoint(now));
  }
  socket_->deliver(now, [this](const SocketAddress& receiver, ByteSpan bytes) { bytesTo_[receiver] += bytes.size(); });
}

std::uint64_t AttackedServer::bytesTo(const SocketAddress& receiver) const {
  const auto found = bytesTo_.find(receiver);
  return found == bytesTo_.end() ? 0 : found->second;
}

}  // namespace platon
