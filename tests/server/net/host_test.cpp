#include "server/net/host.h"

#include <gtest/gtest.h>

#include "tests/support/enet_client.h"
#include "tests/support/raw_datagram.h"
#include "tests/support/wait_until.h"

namespace platon {
namespace {

using namespace std::chrono_literals;

TimePoint steadyNow() { return std::chrono::steady_clock::now(); }

// The error message when this address cannot be opened.
std::string errorOf(const std::string& bind, std::uint16_t port) {
  try {
    const Host host({bind, port, 4, 4}, steadyNow());
    return "none";
  } catch (const HostError& error) {
    return error.what();
  }
}

/// A host and a client without a game, over loopback in real time.
class HostTest : public testing::Test {
 protected:
  HostTest() : host_({"127.0.0.1", 0, 4, 4}, steadyNow()), client_(host_.port(), std::nullopt) {}

  // Serves both until `done`, for at most 20 s.
  template <class Done>
  bool run(Done done) {
    const auto step = [this] {
      client_.step();
      for (HostEvent& event : host_.service(steadyNow())) events_.push_back(std::move(event));
      host_.flush(steadyNow());
    };
    return stepUntil(step, done);
  }

  // Connects the client and sends a message, so that its number becomes known.
  ClientId connect() {
    EXPECT_TRUE(run([this] { return client_.connected(); }));
    client_.sendRaw({1, 2, 3}, true);
    EXPECT_TRUE(run([this] { return !events_.empty(); }));
    return events_.at(0).client;
  }

  Host host_;
  EnetClient client_;
  std::vector<HostEvent> events_;
};

TEST(Host, SaysWhyItCannotListen) {
  const Host host({"127.0.0.1", 0, 4, 4}, steadyNow());
  const std::string port = std::to_string(host.port());
  EXPECT_EQ(errorOf("127.0.0.1", host.port()),
            "cannot listen on 127.0.0.1:" + port +
                ": Address already in use; stop the program that uses it or choose another port");
  EXPECT_EQ(errorOf("here", 0), "cannot listen on 'here': not an IPv4 address, such as 0.0.0.0 or 127.0.0.1");
}

TEST_F(HostTest, DeliversTheMessagesOfAClient) {
  EXPECT_TRUE(host_.empty());
  const ClientId client = connect();
  EXPECT_FALSE(host_.empty());
  EXPECT_FALSE(events_[0].disconnected);
  EXPECT_EQ(events_[0].bytes, (std::vector<std::uint8_t>{1, 2, 3}));
  EXPECT_EQ(events_[0].origin, 0u);  // loopback
  EXPECT_TRUE(host_.isOpen(client));
  EXPECT_FALSE(host_.isOpen(client + 1));
}

TEST_F(HostTest, ReportsThatAClientHasDisconnected) {
  const ClientId client = connect();
  host_.close(client, steadyNow());
  EXPECT_FALSE(host_.isOpen(client));
  EXPECT_TRUE(run([this] { return client_.disconnected() && host_.empty(); }));
  ASSERT_EQ(events_.size(), 2u);
  EXPECT_TRUE(events_[1].disconnected);
  EXPECT_EQ(events_[1].client, client);
}

TEST_F(HostTest, AnAdmittedConnectionEndsAfterFiveSecondsOfSilence) {
  const ClientId client = connect();
  host_.admit(client);
  const TimePoint silent = steadyNow();
  EXPECT_TRUE(host_.service(silent + 4s).empty());
  EXPECT_TRUE(host_.isOpen(client));
  const std::vector<HostEvent> events = host_.service(silent + 5s);
  ASSERT_EQ(events.size(), 1u);
  EXPECT_TRUE(events[0].disconnected);
  EXPECT_TRUE(host_.empty());
  EXPECT_EQ(host_.counters().expired, 0u);
}

TEST_F(HostTest, AConnectionThatIsNotAdmittedExpires) {
  const ClientId client = connect();
  const TimePoint connected = steadyNow();
  host_.service(connected + Host::kAdmissionTime - 5s);
  EXPECT_TRUE(host_.isOpen(client));
  host_.service(connected + Host::kAdmissionTime);
  EXPECT_FALSE(host_.isOpen(client));
  EXPECT_EQ(host_.counters().expired, 1u);
}

TEST_F(HostTest, InvalidDatagramsAreCounted) {
  const RawSocket attacker(host_.port());
  attacker.send(Bytes{0});
  EXPECT_TRUE(run([this] { return host_.counters().invalidDatagrams == 1; }));
}

TEST_F(HostTest, DatagramsBeyondTheBudgetOfTheirConnectionAreDropped) {
  connect();
  for (int i = 0; i < 600; ++i) client_.sendRaw({1}, false);
  EXPECT_TRUE(run([this] { return host_.counters().excessDatagrams > 100; }));
}

}  // namespace
}  // namespace platon
