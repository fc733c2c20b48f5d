#include "client/net/network_conditions.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "client/net/enet_link.h"
#include "protocol/transport/udp_socket.h"
#include "tests/support/wait_until.h"

namespace platon::network_conditions_test {
namespace {

using std::chrono::microseconds;
using std::chrono::milliseconds;

constexpr int kDatagrams = 20000;

struct Arrival {
  int number;
  Time sent;
  Time received;
};

std::vector<std::uint8_t> numbered(int number) {
  return {static_cast<std::uint8_t>(number & 0xff), static_cast<std::uint8_t>(number >> 8 & 0xff)};
}

// Sends one datagram every 10 ms and receives every millisecond.
std::vector<Arrival> transmit(const LinkQuality& quality, std::uint64_t seed) {
  NetworkConditions link(quality, seed);
  std::vector<Arrival> arrivals;
  for (int ms = 0; ms < kDatagrams * 10 + 5000; ++ms) {
    if (ms % 10 == 0 && ms / 10 < kDatagrams) link.send(numbered(ms / 10), milliseconds(ms));
    while (const auto datagram = link.receive(milliseconds(ms))) {
      const int number = (*datagram)[0] | (*datagram)[1] << 8;
      arrivals.push_back({number, milliseconds(number * 10), milliseconds(ms)});
    }
  }
  EXPECT_EQ(link.pending(), 0u);
  return arrivals;
}

bool inOrder(const std::vector<Arrival>& arrivals) {
  return std::is_sorted(arrivals.begin(), arrivals.end(),
                        [](const Arrival& a, const Arrival& b) { return a.number < b.number; });
}

std::vector<std::pair<int, Time>> keysOf(const std::vector<Arrival>& arrivals) {
  std::vector<std::pair<int, Time>> keys;
  for (const Arrival& arrival : arrivals) keys.emplace_back(arrival.number, arrival.received);
  return keys;
}

TEST(NetworkConditions, PerfectConditionsDeliverAtOnce) {
  const LinkQuality perfect;
  EXPECT_TRUE(perfect.perfect());
  const auto arrivals = transmit(perfect, 1);
  ASSERT_EQ(arrivals.size(), std::size_t{kDatagrams});
  EXPECT_TRUE(inOrder(arrivals));
  for (const Arrival& arrival : arrivals) ASSERT_EQ(arrival.received, arrival.sent);
}

TEST(NetworkConditions, LosesTheGivenShare) {
  LinkQuality quality;
  quality.lossPercent = 20;
  EXPECT_FALSE(quality.perfect());
  EXPECT_NEAR(static_cast<double>(transmit(quality, 2).size()), kDatagrams * 0.8, kDatagrams * 0.01);
}

TEST(NetworkConditions, DelaysWithinItsBoundsAndKeepsTheOrder) {
  LinkQuality quality;
  quality.delayMs = 50;
  quality.jitterMs = 30;
  const auto arrivals = transmit(quality, 3);
  ASSERT_EQ(arrivals.size(), std::size_t{kDatagrams});
  EXPECT_TRUE(inOrder(arrivals));
  Time longest{};
  for (const Arrival& arrival : arrivals) {
    ASSERT_GE(arrival.received - arrival.sent, milliseconds(50));
    ASSERT_LE(arrival.received - arrival.sent, milliseconds(81));
    longest = std::max(longest, arrival.received - arrival.sent);
  }
  EXPECT_GT(longest, milliseconds(75));
}

TEST(NetworkConditions, DuplicatesTheGivenShare) {
  LinkQuality quality;
  quality.duplicatePercent = 10;
  std::map<int, int> copies;
  for (const Arrival& arrival : transmit(quality, 4)) ++copies[arrival.number];
  EXPECT_EQ(copies.size(), std::size_t{kDatagrams});
  const auto twice = std::count_if(copies.begin(), copies.end(), [](const auto& entry) { return entry.second == 2; });
  EXPECT_NEAR(static_cast<double>(twice), kDatagrams * 0.1, kDatagrams * 0.01);
}

TEST(NetworkConditions, ReordersTheGivenShare) {
  LinkQuality quality;
  quality.reorderPercent = 10;
  const auto arrivals = transmit(quality, 5);
  ASSERT_EQ(arrivals.size(), std::size_t{kDatagrams});
  int overtaken = 0;
  int newest = -1;
  for (const Arrival& arrival : arrivals) {
    overtaken += arrival.number < newest ? 1 : 0;
    newest = std::max(newest, arrival.number);
  }
  EXPECT_NEAR(overtaken, kDatagrams * 0.1, kDatagrams * 0.01);
}

// Whether each of many datagrams is lost.
std::vector<bool> losses(const LinkQuality& quality, std::uint64_t seed, int datagrams) {
  NetworkConditions link(quality, seed);
  std::vector<bool> lost;
  for (int i = 0; i < datagrams; ++i) {
    link.send({0}, milliseconds(i));
    lost.push_back(!link.receive(milliseconds(i)));
  }
  return lost;
}

double shareOf(const std::vector<bool>& lost) {
  return static_cast<double>(std::count(lost.begin(), lost.end(), true)) / static_cast<double>(lost.size());
}

std::ptrdiff_t countRuns(const std::vector<bool>& lost) {
  bool before = false;
  return std::count_if(lost.begin(), lost.end(), [&](bool now) { return !std::exchange(before, now) && now; });
}

struct Bursts {
  double percent;
  double length;
};

class LossInBursts : public testing::TestWithParam<Bursts> {
 protected:
  static constexpr int kCount = 1000000;

  LossInBursts() {
    quality_.burstLossPercent = GetParam().percent;
    quality_.burstLength = GetParam().length;
  }

  // Five standard deviations of the share lost. The states of a two-state Markov chain n steps apart are correlated by
  // (1 − p − q)^n.
  double shareTolerance() const {
    const double leave = 1 / GetParam().length;
    const double correlation = 1 - leave / (1 - share_);
    return 5 * std::sqrt(share_ * (1 - share_) / kCount * (1 + correlation) / (1 - correlation));
  }

  LinkQuality quality_;
  double share_ = GetParam().percent / 100;
};

TEST_P(LossInBursts, LosesTheGivenShareInRunsOfTheGivenMeanLength) {
  EXPECT_FALSE(quality_.perfect());
  const std::vector<bool> lost = losses(quality_, 8, kCount);
  EXPECT_NEAR(shareOf(lost), share_, shareTolerance());
  const auto runs = static_cast<double>(countRuns(lost));
  const double length = GetParam().length;
  EXPECT_NEAR(shareOf(lost) * kCount / runs, length, 5 * std::sqrt(length * (length - 1) / runs) + length / runs);
}

TEST_P(LossInBursts, IsIndependentOfRandomLoss) {
  quality_.lossPercent = 20;
  const double left = (1 - share_) * 0.8;
  const double random = 5 * std::sqrt(0.2 * 0.8 / kCount);
  EXPECT_NEAR(1 - shareOf(losses(quality_, 9, kCount)), left, shareTolerance() * 0.8 + random);
}

INSTANTIATE_TEST_SUITE_P(NetworkConditions, LossInBursts,
                         testing::Values(Bursts{1, 10}, Bursts{5, 1}, Bursts{10, 3.5}, Bursts{50, 4}, Bursts{90, 20}),
                         [](const auto& test) { return "Case" + std::to_string(test.index); });

TEST(NetworkConditions, KeepsTheShareByLongerBurstsIfNeeded) {
  LinkQuality quality;
  quality.burstLossPercent = 80;
  quality.burstLength = 1;  // would allow a share of one half at most
  const std::vector<bool> lost = losses(quality, 10, 100000);
  EXPECT_NEAR(shareOf(lost), 0.8, 0.01);
  EXPECT_NEAR(shareOf(lost) * 100000 / static_cast<double>(countRuns(lost)), 4, 0.1);
  quality.burstLossPercent = 100;
  EXPECT_EQ(shareOf(losses(quality, 10, 1000)), 1);
}

struct Sent {
  Time at;
  std::size_t bytes;
};

// Arrival time of each datagram; nothing for lost ones.
std::vector<std::optional<Time>> arrivalsOf(const LinkQuality& quality, const std::vector<Sent>& datagrams) {
  NetworkConditions link(quality, 11);
  std::vector<std::optional<Time>> arrivals(datagrams.size());
  std::size_t next = 0;
  const Time end = datagrams.back().at + std::chrono::seconds(5);
  for (Time now{}; now <= end; now += microseconds(500)) {
    for (; next < datagrams.size() && datagrams[next].at <= now; ++next) {
      link.send(std::vector<std::uint8_t>(datagrams[next].bytes, static_cast<std::uint8_t>(next)), now);
    }
    while (const auto datagram = link.receive(now)) arrivals[(*datagram)[0]] = now;
  }
  return arrivals;
}

TEST(NetworkConditions, RateSpacesDatagramsSentTogether) {
  LinkQuality quality;
  quality.kilobytesPerSecond = 10;
  EXPECT_FALSE(quality.perfect());
  const Time start = milliseconds(7);
  const auto arrivals =
      arrivalsOf(quality, {{start, 100}, {start, 100}, {start, 50}, {start, 5}, {start + milliseconds(100), 100}});
  const std::vector<std::optional<Time>> expected = {start + milliseconds(10), start + milliseconds(20),
                                                     start + milliseconds(25), start + microseconds(25500),
                                                     start + milliseconds(110)};
  EXPECT_EQ(arrivals, expected);
}

TEST(NetworkConditions, DelayStartsAfterTheBottleneck) {
  LinkQuality quality;
  quality.kilobytesPerSecond = 10;
  quality.delayMs = 30;
  const std::vector<std::optional<Time>> expected = {milliseconds(40), milliseconds(50)};
  EXPECT_EQ(arrivalsOf(quality, {{Time(0), 100}, {Time(0), 100}}), expected);
}

// At 10 bytes per millisecond the sixth datagram waits exactly 250 ms, which is allowed.
TEST(NetworkConditions, AFullQueueDropsNewDatagrams) {
  LinkQuality quality;
  quality.kilobytesPerSecond = 10;
  std::vector<Sent> datagrams(9, {Time(0), 500});
  datagrams.push_back({milliseconds(49), 1});
  datagrams.push_back({milliseconds(50), 1});
  const auto arrivals = arrivalsOf(quality, datagrams);
  for (int i = 0; i < 6; ++i) EXPECT_EQ(arrivals[static_cast<std::size_t>(i)], milliseconds(50 * (i + 1))) << i;
  for (std::size_t i = 6; i < 10; ++i) EXPECT_EQ(arrivals[i], std::nullopt) << i;
  EXPECT_EQ(arrivals[10], microseconds(300500));  // after the queued ones
}

TEST(NetworkConditions, TheQueueIsBounded) {
  LinkQuality quality;
  quality.kilobytesPerSecond = 1;
  NetworkConditions link(quality, 12);
  std::size_t most = 0;
  for (int ms = 0; ms < 60000; ++ms) {
    link.send(std::vector<std::uint8_t>(10), milliseconds(ms));
    while (link.receive(milliseconds(ms))) {
    }
    most = std::max(most, link.pending());
  }
  EXPECT_EQ(most, 26u);  // 250 bytes waiting and one datagram passing
}

TEST(NetworkConditions, LostDatagramsOccupyTheBottleneck) {
  LinkQuality quality;
  quality.kilobytesPerSecond = 10;
  quality.lossPercent = 50;
  const auto arrivals = arrivalsOf(quality, std::vector<Sent>(6, {Time(0), 100}));
  const auto lost = std::count(arrivals.begin(), arrivals.end(), std::nullopt);
  EXPECT_GT(lost, 0);
  EXPECT_LT(lost, 6);
  for (std::size_t i = 0; i < arrivals.size(); ++i) {
    EXPECT_EQ(arrivals[i].value_or(milliseconds(10) * (i + 1)), milliseconds(10) * (i + 1));
  }
}

TEST(NetworkConditions, ARateAboveTheLoadAddsOnlyTheTransmissionTime) {
  LinkQuality quality;
  quality.kilobytesPerSecond = 2;  // 2 bytes per millisecond; the load is 0.2
  const auto arrivals = transmit(quality, 13);
  ASSERT_EQ(arrivals.size(), std::size_t{kDatagrams});
  for (const Arrival& arrival : arrivals) ASSERT_EQ(arrival.received - arrival.sent, milliseconds(1));
}

TEST(NetworkConditions, ARateFarAboveTheLoadChangesNoDelivery) {
  LinkQuality quality;
  quality.lossPercent = 10;
  quality.jitterMs = 20;
  quality.duplicatePercent = 5;
  LinkQuality wide = quality;
  wide.kilobytesPerSecond = 1e6;
  EXPECT_EQ(keysOf(transmit(wide, 14)), keysOf(transmit(quality, 14)));
}

int flippedBits(const std::vector<std::uint8_t>& datagram, const std::vector<std::uint8_t>& sent) {
  int count = 0;
  for (std::size_t i = 0; i < sent.size(); ++i) count += std::popcount(static_cast<unsigned>(datagram[i] ^ sent[i]));
  return count;
}

TEST(NetworkConditions, FlipsOneBitInTheGivenShareOfCopies) {
  LinkQuality quality;
  quality.corruptPercent = 10;
  EXPECT_FALSE(quality.perfect());
  quality.duplicatePercent = 100;
  NetworkConditions link(quality, 15);
  const std::vector<std::uint8_t> sent = {0x00, 0xff, 0x5a, 0x12};
  std::map<int, int> copies;  // by bits flipped
  std::map<int, int> pairs;   // by number of damaged copies
  std::set<std::string> kinds;
  for (int i = 0; i < kDatagrams; ++i) {
    link.send(sent, milliseconds(i));
    int damaged = 0;
    while (const auto datagram = link.receive(milliseconds(i))) {
      ASSERT_EQ(datagram->size(), sent.size());
      ++copies[flippedBits(*datagram, sent)];
      kinds.emplace(datagram->begin(), datagram->end());
      damaged += *datagram == sent ? 0 : 1;
    }
    ++pairs[damaged];
  }
  EXPECT_EQ(copies.size(), 2u);
  EXPECT_EQ(copies[0] + copies[1], 2 * kDatagrams);
  EXPECT_NEAR(copies[1], 2 * kDatagrams * 0.1, 5 * std::sqrt(2 * kDatagrams * 0.1 * 0.9));
  EXPECT_NEAR(pairs[2], kDatagrams * 0.01, 5 * std::sqrt(kDatagrams * 0.01));  // independently
  EXPECT_EQ(kinds.size(), 33u);                                                // each of the 32 bits, and none
}

TEST(NetworkConditions, DeliversAnEmptyDatagramUncorrupted) {
  LinkQuality quality;
  quality.corruptPercent = 100;
  NetworkConditions link(quality, 16);
  link.send({}, Time(0));
  EXPECT_EQ(link.receive(Time(0)), std::vector<std::uint8_t>());
}

TEST(NetworkConditions, TheSameSeedGivesTheSameDeliveries) {
  LinkQuality quality;
  quality.lossPercent = 10;
  quality.burstLossPercent = 5;
  quality.jitterMs = 20;
  quality.reorderPercent = 5;
  quality.kilobytesPerSecond = 0.25;
  EXPECT_EQ(keysOf(transmit(quality, 6)), keysOf(transmit(quality, 6)));
  EXPECT_NE(keysOf(transmit(quality, 6)), keysOf(transmit(quality, 7)));
}

TEST(NetworkConditions, AnotherQualityAppliesToWhatIsSentAfterwards) {
  NetworkConditions link({}, 1);
  link.send(numbered(1), milliseconds(0));
  LinkQuality slow;
  slow.delayMs = 50;
  link.setQuality(slow);
  link.send(numbered(2), milliseconds(0));
  EXPECT_EQ(link.receive(milliseconds(0)), numbered(1));
  EXPECT_EQ(link.receive(milliseconds(49)), std::nullopt);
  EXPECT_EQ(link.receive(milliseconds(50)), numbered(2));
}

using std::chrono::milliseconds;

// A UDP socket on a free loopback port.
class Socket {
 public:
  Socket() : handle_(socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK, 0)) {
    sockaddr_in own = loopback(0);
    socklen_t size = sizeof own;
    if (bind(handle_, reinterpret_cast<sockaddr*>(&own), size) != 0 ||
        getsockname(handle_, reinterpret_cast<sockaddr*>(&own), &size) != 0) {
      throw std::runtime_error("no socket");
    }
    port_ = ntohs(own.sin_port);
  }
  ~Socket() { close(handle_); }
  Socket(const Socket&) = delete;
  Socket& operator=(const Socket&) = delete;

  std::uint16_t port() const { return port_; }
  void send(const std::string& text, std::uint16_t port) {
    const sockaddr_in to = loopback(port);
    ASSERT_EQ(sendto(handle_, text.data(), text.size(), 0, reinterpret_cast<const sockaddr*>(&to), sizeof to),
              static_cast<ssize_t>(text.size()));
  }
  // The next datagram, if one has arrived. Sets `senderPort()`.
  std::optional<std::string> receive() {
    char buffer[256];
    sockaddr_in from{};
    socklen_t size = sizeof from;
    const ssize_t count = recvfrom(handle_, buffer, sizeof buffer, 0, reinterpret_cast<sockaddr*>(&from), &size);
    if (count < 0) return std::nullopt;
    senderPort_ = ntohs(from.sin_port);
    return std::string(buffer, static_cast<std::size_t>(count));
  }
  // The port that the last datagram came from.
  std::uint16_t senderPort() const { return senderPort_; }

 private:
  static sockaddr_in loopback(std::uint16_t port) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons(port);
    return address;
  }

  int handle_;
  std::uint16_t port_ = 0;
  std::uint16_t senderPort_ = 0;
};

class LossyRelayTest : public testing::Test {
 protected:
  void start(const LinkQuality& quality) { relay_.emplace(ServerAddress{"127.0.0.1", server_.port()}, quality, 1); }
  void sendToRelay(Socket& from, const std::string& text) { from.send(text, relay_->address().port); }
  void pump() { relay_->pump(now_ += milliseconds(1)); }

  // Pumps the relay until the socket receives a datagram.
  std::optional<std::string> receive(Socket& socket) {
    std::optional<std::string> datagram;
    const auto step = [&] {
      pump();
      datagram = socket.receive();
    };
    stepUntil(step, [&] { return datagram.has_value(); });
    return datagram;
  }

  // Expects that the relay has sent nothing more: a datagram sent to the socket directly is the next one.
  void expectNothingMore(Socket& socket) {
    Socket direct;
    for (int ms = 0; ms < 100; ++ms) pump();
    direct.send("direct", socket.port());
    EXPECT_EQ(receive(socket), "direct");
  }

  Socket server_;
  std::optional<LossyRelay> relay_;
  Time now_{};
};

TEST_F(LossyRelayTest, ForwardsDatagramsBothWaysWithDelay) {
  Socket client;
  LinkQuality slow;
  slow.delayMs = 30;
  start(slow);
  sendToRelay(client, "question");
  ASSERT_EQ(receive(server_), "question");
  EXPECT_GE(now_, milliseconds(30));
  const Time answered = now_;
  server_.send("answer", server_.senderPort());
  EXPECT_EQ(receive(client), "answer");
  EXPECT_GE(now_ - answered, milliseconds(30));
}

TEST_F(LossyRelayTest, DropsEverythingAtFullLoss) {
  Socket client;
  LinkQuality lossy;
  lossy.lossPercent = 100;
  start(lossy);
  sendToRelay(client, "question");
  expectNothingMore(server_);
}

template <class Call>
std::string fault(Call call) {
  try {
    call();
    return "none";
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

TEST(LossyRelay, ReportsAnUnknownHostLikeAConnection) {
  const ServerAddress nowhere{"no such host", 1};
  EXPECT_EQ(fault([&] { LossyRelay(nowhere, LinkQuality(), 1); }), "cannot resolve host no such host");
  EXPECT_EQ(fault([&] { resolve(nowhere.host, nowhere.port); }), "cannot resolve host no such host");
}

// Behaves like a NAT router: the server sees a new address, and datagrams to the old one are lost.
TEST_F(LossyRelayTest, AClientOnANewPortGetsANewPortTowardsTheServer) {
  Socket before, after;
  LinkQuality quality;
  quality.delayMs = 50;
  start(quality);
  sendToRelay(before, "one");
  ASSERT_EQ(receive(server_), "one");
  const std::uint16_t first = server_.senderPort();
  server_.send("to the first", first);
  sendToRelay(before, "too late");
  pump();
  sendToRelay(after, "two");
  ASSERT_EQ(receive(server_), "two");
  const std::uint16_t second = server_.senderPort();
  EXPECT_NE(first, second);
  server_.send("to the first again", first);
  server_.send("to the second", second);
  EXPECT_EQ(receive(after), "to the second");
  expectNothingMore(after);
  expectNothingMore(before);
}

TEST(ServerRoute, IsDirectUnderPerfectConditions) {
  const ServerRoute route({"example.invalid", 7801}, LinkQuality(), 1);
  EXPECT_EQ(route.address().text(), "example.invalid:7801");
}

TEST(ServerRoute, UsesALocalRelayUnderSimulatedConditions) {
  LinkQuality quality;
  quality.delayMs = 1;
  const ServerRoute route({"127.0.0.1", 7801}, quality, 1);
  EXPECT_EQ(route.address().host, "127.0.0.1");
  EXPECT_NE(route.address().port, 7801);
}

TEST(ServerRoute, ThrowsForAnUnknownHostBehindARelay) {
  LinkQuality quality;
  quality.delayMs = 1;
  EXPECT_THROW(ServerRoute({"no such host", 1}, quality, 1), std::runtime_error);
}

}  // namespace
}  // namespace platon::network_conditions_test
