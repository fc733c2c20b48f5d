// Players who go on from another address, on a whole server in virtual time.
#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "client/net/enet_link.h"
#include "server/app/dedicated_server.h"
#include "tests/net/support/datagram_network.h"
#include "tests/support/test_levels.h"

namespace platon::roaming_test {
namespace {

using namespace std::chrono_literals;

/// A client that joins, resumes with its token, and can go on from another address.
class Roamer {
 public:
  Roamer(DatagramNetwork& network, const SocketAddress& own, const SocketAddress& server, std::uint8_t token)
      : Roamer(std::make_unique<Socket>(network, own), server, token) {}

  void move(const SocketAddress& own) { socket_->move(own); }

  void step(Time now) {
    connection_.service(now, [this](std::span<const std::uint8_t> bytes) {
      const auto message = decodeToClient({bytes.begin(), bytes.end()});
      if (!message) return;
      if (std::holds_alternative<Welcome>(*message)) playing_ = true;
      if (const auto* refused = std::get_if<Refused>(&*message)) refusal_ = refused->reason;
    });
    if (connection_.refused()) refusal_ = connection_.refused()->reason;
    if (connection_.state() != EnetLink::State::kConnected) return;
    Hello hello;
    hello.token = SessionToken{token_};
    if (!std::exchange(greeted_, true)) connection_.send(encode(hello), true);
    connection_.send(encode(LevelRequest{1}), false);
    connection_.flush(now);
  }

  bool playing() const { return playing_; }
  const std::string& refusal() const { return refusal_; }

 private:
  class Socket : public DatagramSocket {
   public:
    Socket(DatagramNetwork& network, const SocketAddress& own) : network_(network), own_(network.socket(own)) {}

    void move(const SocketAddress& own) { own_ = network_.socket(own); }
    std::optional<Datagram> receive(Time now) override { return own_->receive(now); }
    void send(const SocketAddress& receiver, ByteSpan bytes, Time now) override { own_->send(receiver, bytes, now); }
    void flush(Time now) override { own_->flush(now); }
    void wait(std::chrono::milliseconds) override {}
    SocketAddress address() const override { return own_->address(); }

   private:
    DatagramNetwork& network_;
    std::unique_ptr<DatagramSocket> own_;
  };

  Roamer(std::unique_ptr<Socket> socket, const SocketAddress& server, std::uint8_t token)
      : socket_(socket.get()), connection_(std::move(socket), {server}, {}), token_(token) {}

  Socket* socket_;  // connection_ owns it
  EnetLink connection_;
  std::uint8_t token_;
  bool greeted_ = false;
  bool playing_ = false;
  std::string refusal_;
};

class RoamingTest : public testing::Test {
 protected:
  static inline const SocketAddress kServer = addressAt("198.51.100.1", 7777);
  static inline const char* const kHome = "192.0.2.1";
  static inline const char* const kAway = "203.0.113.9";

  Roamer& join(const char* ip, int token) {
    players_.push_back(
        std::make_unique<Roamer>(network_, addressAt(ip, nextPort_++), kServer, static_cast<std::uint8_t>(token)));
    run();
    return *players_.back();
  }

  void moveAll(const char* ip) {
    for (const auto& player : players_) player->move(addressAt(ip, nextPort_++));
    run();
  }

  // As long as a household needs for its next handshake.
  void run() {
    for (int step = 0; step < 60; ++step) {
      now_ += 10ms;
      for (const auto& player : players_) player->step(timeOf(now_));
      server_.step(now_);
    }
    network_.forgetSent();
  }

  std::size_t playersAt(const char* ip) const {
    const std::vector<PlayerStatus> players = server_.match().playerStatus();
    return static_cast<std::size_t>(std::count_if(players.begin(), players.end(), [ip](const PlayerStatus& each) {
      return each.client && each.address == IpAddress::parse(ip);
    }));
  }

  DatagramNetwork network_;
  DedicatedServer server_{
      network_.socket(kServer), {}, {levelOf(farGoalText())}, {LogFormat::kText, [](std::string_view) {}}};
  TimePoint now_{std::chrono::hours(1)};
  std::vector<std::unique_ptr<Roamer>> players_;
  std::uint16_t nextPort_ = 4000;
};

// Neither moving nor resuming asked: two households took all places of a server, and others were told that it is full.
TEST_F(RoamingTest, TwoHouseholdsTakeNoMorePlacesThanTwoMay) {
  for (int round = 0; round < 4; ++round) {
    for (int i = 0; i < 4; ++i) join(kHome, 4 * round + i + 1);
    moveAll(kAway);
    for (int i = 0; i < 4; ++i) join(kAway, 4 * round + i + 1);
  }
  EXPECT_LE(playersAt(kHome), 4u);
  EXPECT_LE(playersAt(kAway), 4u);
  EXPECT_LE(server_.match().allPlayers(), 8u);
  EXPECT_TRUE(join("198.51.100.7", 99).playing());
}

TEST_F(RoamingTest, AllPlayersOfAHouseholdThatGetsAnotherAddressGoOnThere) {
  for (int i = 1; i <= 4; ++i) EXPECT_TRUE(join(kHome, i).playing());
  moveAll(kAway);
  EXPECT_EQ(playersAt(kAway), 4u);
}

// The server sends to its old address, and takes what comes from the new one.
TEST_F(RoamingTest, APlayerWhoComesToAFullHouseholdIsToldSoWhenItResumes) {
  for (int i = 1; i <= 4; ++i) join(kAway, i);
  Roamer& guest = join(kHome, 5);
  guest.move(addressAt(kAway, nextPort_++));
  run();
  EXPECT_EQ(playersAt(kHome), 1u) << "it counts where it was";
  EXPECT_EQ(server_.match().allPlayers(), 5u);
  Roamer& again = join(kAway, 5);
  EXPECT_FALSE(again.playing());
  EXPECT_EQ(again.refusal(), "your address already has 4 players, which is all that this server allows");
  guest.move(addressAt(kHome, nextPort_++));
  run();
  EXPECT_EQ(playersAt(kHome), 1u);
}

}  // namespace
}  // namespace platon::roaming_test
