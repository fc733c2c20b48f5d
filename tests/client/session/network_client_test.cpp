#include "client/session/network_client.h"
#include "protocol/transport/udp_socket.h"

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>

#include "client/play/embedded_server.h"
#include "client/time/steady_now.h"
#include "server/net/host.h"

namespace platon {
namespace {

using std::chrono::milliseconds;

const Controls kRight = [](const Game&, std::uint32_t) { return Input{Input::kRight}; };

// Updates until `done`, at most 10 s. Returns whether it is done.
template <class Done>
bool updateUntil(NetworkClient& client, Done done) {
  const Clock clock = steadyClock();
  const Moment end = clock.now() + std::chrono::seconds(10);
  for (Moment now = clock.now(); now < end; now = clock.now()) {
    client.update(now, kRight);
    if (done()) return true;
    clock.sleepUntil(now + milliseconds(2));
  }
  return false;
}

TEST(NetworkClient, ReportsThatNoServerAnswers) {
  const Moment start = std::chrono::hours(1);
  NetworkClient client({"127.0.0.1", 1}, {""}, start);
  for (Moment now = start; now <= start + NetworkClient::kConnectTimeout; now += milliseconds(50)) {
    client.update(now, kRight);
    ASSERT_EQ(client.ending(), std::nullopt);
  }
  client.update(start + NetworkClient::kConnectTimeout + milliseconds(1), kRight);
  EXPECT_EQ(client.ending(), "no answer from 127.0.0.1:1 within 5 s: is platon-server running there?");
}

TEST(NetworkClient, TriesThreeTimesToJoinAServerThatDoesNotWelcomeIt) {
  Moment now = steadyClock().now();
  Host host(std::make_unique<UdpSocket>("127.0.0.1", 0), ServerIdentity::random(), {}, now);
  NetworkClient client({"127.0.0.1", host.address().port}, {""}, now);
  std::set<ClientId> greeted;
  for (const Moment end = now + std::chrono::minutes(2); now < end && !client.ending(); now += milliseconds(10)) {
    for (const HostEvent& event : host.service(now)) greeted.insert(event.client);
    host.flush(now);
    client.update(now, kRight);
  }
  ASSERT_TRUE(client.ending().has_value());
  EXPECT_TRUE(client.ending()->ends_with("did not respond in time; try again")) << *client.ending();
  EXPECT_EQ(greeted.size(), NetworkClient::kMaxFirstAttempts);
}

TEST(NetworkClient, ThrowsForAnUnknownHost) {
  EXPECT_THROW(NetworkClient({"no such host", 1}, {""}, Moment(1)), std::runtime_error);
}

TEST(NetworkClient, PlaysOnAnEmbeddedServer) {
  const EmbeddedServer server("levels/hexahedron/01_first_steps.level");
  NetworkClient client(server.address(), {"someone"}, steadyClock().now());
  ASSERT_TRUE(updateUntil(client, [&] {
    return client.session() != nullptr && client.session()->predictionStatistics().confirmedTicks > 60;
  })) << client.ending().value_or("timed out");
  EXPECT_TRUE(client.session()->round()->prediction().present());
  EXPECT_EQ(client.session()->roundStatistics().desyncs, 0u);
  EXPECT_GT(client.traffic().sentBytes, 0u);
  EXPECT_GT(client.traffic().receivedPackets, 30u);
  EXPECT_GT(client.traffic().longestDatagram, 1000u);  // a chunk of the level
  EXPECT_LE(client.traffic().longestDatagram, 1200u);
  client.leave();
  EXPECT_TRUE(updateUntil(client, [&] { return client.closed(); }));
  EXPECT_EQ(client.ending(), std::nullopt);
}

}  // namespace
}  // namespace platon
