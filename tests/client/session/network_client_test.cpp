#include "client/session/network_client.h"

#include <gtest/gtest.h>

#include <functional>
#include <set>
#include <stdexcept>

#include "client/net/enet_link.h"
#include "client/play/match/embedded_server.h"
#include "client/time/steady_now.h"
#include "protocol/transport/udp_socket.h"
#include "server/net/host.h"
#include "tests/client/play/match/on_loopback.h"

namespace platon::network_client_test {
namespace {

using std::chrono::milliseconds;

const Controls kRight = [](const Game&, std::uint32_t) { return Input{Input::kRight}; };

// Updates until `done`, at most 10 s. Returns whether it is done.
template <class Done>
bool updateUntil(NetworkClient& client, Done done) {
  const Clock clock = steadyClock();
  const Time end = clock.now() + std::chrono::seconds(10);
  for (Time now = clock.now(); now < end; now = clock.now()) {
    client.update(now, kRight);
    if (done()) return true;
    clock.sleepUntil(now + milliseconds(2));
  }
  return false;
}

TEST(NetworkClient, ReportsThatNoServerAnswers) {
  const Time start = std::chrono::hours(1);
  NetworkClient client(enetLinks({"127.0.0.1", 1}), {""}, start);
  for (Time now = start; now <= start + NetworkClient::kConnectTimeout; now += milliseconds(50)) {
    client.update(now, kRight);
    ASSERT_EQ(client.ending(), std::nullopt);
  }
  client.update(start + NetworkClient::kConnectTimeout + milliseconds(1), kRight);
  EXPECT_EQ(client.ending(), "no answer from 127.0.0.1:1 within 5 s: is platon-server running there?");
}

/// A client of a host that answers the first message of each connection as a test wants.
class AnsweredClient : public testing::Test {
 protected:
  using Answer = std::function<void(Host&, ClientId, Time)>;

  // Returns when the client gives up, has tried `attempts` times, or two minutes of virtual time have passed.
  void run(std::size_t attempts, const Answer& answer) {
    for (const Time end = now_ + std::chrono::minutes(2); now_ < end && !client_.ending(); now_ += milliseconds(10)) {
      for (const HostEvent& event : host_.service(now_)) {
        if (!event.disconnected && greeted_.insert(event.client).second) answer(host_, event.client, now_);
      }
      if (greeted_.size() == attempts) return;
      host_.flush(now_);
      client_.update(now_, kRight);
    }
  }

  Time now_ = steadyClock().now();
  Host host_{std::make_unique<UdpSocket>("127.0.0.1", 0), ServerIdentity::random(), {}, now_};
  NetworkClient client_{enetLinks({"127.0.0.1", host_.address().port}), {""}, now_};
  std::set<ClientId> greeted_;
};

// Both in one datagram, after which the connection is closed.
void welcomeAndClose(Host& host, ClientId client, Time now, ByeCode code) {
  host.send(client, true, encode(Welcome{0, 1, 2, 4, kTicksPerSecond, ""}));
  host.send(client, true, encode(Bye{code, "why"}));
  host.close(client, now);
}

TEST_F(AnsweredClient, TriesThreeTimesToJoinAServerThatDoesNotWelcomeIt) {
  run(100, [](Host&, ClientId, Time) {});
  ASSERT_TRUE(client_.ending().has_value());
  EXPECT_TRUE(client_.ending()->ends_with("did not respond in time; try again")) << *client_.ending();
  EXPECT_EQ(greeted_.size(), NetworkClient::kMaxFirstAttempts);
}

TEST_F(AnsweredClient, RetriesWhenWelcomeAndByeArriveInOneServiceCall) {
  const std::size_t attempts = 2 * NetworkClient::kMaxFirstAttempts;
  run(attempts,
      [](Host& host, ClientId client, Time now) { welcomeAndClose(host, client, now, ByeCode::kServerStops); });
  EXPECT_EQ(greeted_.size(), attempts);
  EXPECT_EQ(client_.ending(), std::nullopt);
  EXPECT_EQ(client_.outage(), "the server ended the game: why");
  EXPECT_TRUE(client_.welcomed());
}

TEST_F(AnsweredClient, EndsWhenItIsRemovedInTheServiceCallOfItsWelcome) {
  run(100, [](Host& host, ClientId client, Time now) { welcomeAndClose(host, client, now, ByeCode::kRemoved); });
  EXPECT_EQ(greeted_.size(), 1u);
  EXPECT_EQ(client_.ending(), "the server ended the game: why");
}

TEST_F(AnsweredClient, TellsWhereTheServerSendsIt) {
  run(100, [](Host& host, ClientId client, Time now) {
    host.send(client, true, encode(Refused{RefusalCode::kOther, "why", "[::1]:5"}));
    host.close(client, now);
  });
  ASSERT_TRUE(client_.next().has_value());
  EXPECT_EQ(client_.next()->text(), "[::1]:5");
  EXPECT_EQ(greeted_.size(), 1u);
}

TEST(NetworkClient, ThrowsForAnUnknownHost) { EXPECT_THROW(enetLinks({"no such host", 1}), std::runtime_error); }

TEST(NetworkClient, PlaysOnAnEmbeddedServer) {
  const EmbeddedServer server(onLoopback({"tests/determinism/golden/levels/hexahedron.level"}));
  NetworkClient client(enetLinks(server.address()), {"someone"}, steadyClock().now());
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

class Farewell : public testing::Test {
 protected:
  // Updates until `closeAfter` updates have been made; returns how long it took.
  Time run(int closeAfter) {
    const Time start = now_;
    const auto update = [this](Time now) {
      EXPECT_EQ(now, now_);
      ++updates_;
    };
    updateUntilClosed(clock_, update, [&] { return updates_ >= closeAfter; });
    return now_ - start;
  }

  Time now_ = std::chrono::seconds(7);
  Clock clock_{[this] { return now_; }, [this](Time until) { now_ = until; }};
  int updates_ = 0;
};

TEST_F(Farewell, DoesNotUpdateAClosedConnection) {
  EXPECT_EQ(run(0), Time{});
  EXPECT_EQ(updates_, 0);
}

TEST_F(Farewell, UpdatesEveryTwoMillisecondsUntilClosed) {
  EXPECT_EQ(run(5), milliseconds(10));
  EXPECT_EQ(updates_, 5);
}

TEST_F(Farewell, EndsAfterHalfASecond) {
  EXPECT_EQ(run(100000), milliseconds(500));
  EXPECT_EQ(updates_, 250);
}

}  // namespace
}  // namespace platon::network_client_test
