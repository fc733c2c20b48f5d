#include "protocol/transport/enet_calls.h"

#include <gtest/gtest.h>

#include <vector>

namespace platon::enet_calls_test {
namespace {

/// Two ENet hosts that exchange contents through their ports.
class TestPort : public EnetPort {
 public:
  void sendFromEnet(const ENetAddress& session, ByteSpan bytes) override {
    EXPECT_EQ(session.host, 7u);
    sent.emplace_back(bytes.begin(), bytes.end());
  }
  std::optional<Received> receiveForEnet() override {
    if (waiting.empty()) return std::nullopt;
    current = waiting.front();
    waiting.erase(waiting.begin());
    return Received{{7, 1}, current};
  }

  std::vector<Bytes> sent;
  std::vector<Bytes> waiting;
  Bytes current;
};

TEST(EnetCalls, LibenetUsesThem) { EXPECT_TRUE(enetUsesOurCalls()); }

TEST(EnetCalls, TheTimeIsThatOfTheInnermostScope) {
  TestPort port;
  const EnetScope outer(port, std::chrono::microseconds(5'000'999));
  EXPECT_EQ(enet_time_get(), 5000u);
  {
    const EnetScope inner(port, std::chrono::seconds(9));
    EXPECT_EQ(enet_time_get(), 9000u);
  }
  EXPECT_EQ(enet_time_get(), 5000u);
}

TEST(EnetCalls, TwoHostsConnectWithoutASocket) {
  const std::unique_ptr<ENetHost, void (*)(ENetHost*)> server(enet_host_create(nullptr, 1, 2, 0, 0), enet_host_destroy);
  const std::unique_ptr<ENetHost, void (*)(ENetHost*)> client(enet_host_create(nullptr, 1, 2, 0, 0), enet_host_destroy);
  TestPort serverPort;
  TestPort clientPort;
  const ENetAddress session{7, 1};
  enet_host_connect(client.get(), &session, 2, 0);
  int connected = 0;
  for (int ms = 1; ms < 50; ++ms) {
    for (const auto& [host, port] : {std::pair{server.get(), &serverPort}, std::pair{client.get(), &clientPort}}) {
      const EnetScope scope(*port, std::chrono::milliseconds(ms));
      ENetEvent event{};
      if (enet_host_service(host, &event, 0) > 0 && event.type == ENET_EVENT_TYPE_CONNECT) ++connected;
    }
    std::swap(serverPort.waiting, clientPort.sent);
    std::swap(clientPort.waiting, serverPort.sent);
    serverPort.sent.clear();
    clientPort.sent.clear();
  }
  EXPECT_EQ(connected, 2);
}

}  // namespace
}  // namespace platon::enet_calls_test
