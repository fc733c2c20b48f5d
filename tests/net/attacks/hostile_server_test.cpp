#include "tests/net/attacks/hostile_server.h"

#include <enet/enet.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>

#include "tests/net/attacks/hostile_content.h"
#include "tests/support/run/repetitions.h"

namespace platon::hostile_server_test {
namespace {

constexpr std::int64_t kMegabyte = 1024 * 1024;
constexpr std::uint64_t kHash = 0x1234;
constexpr std::uint32_t kChunk = kChunkBytes;

LevelChunk levelChunk() { return {kHash, kMaxLevelBytes, 0, Bytes(kChunk, '%')}; }

std::string reasonOf(const HostileServer& server) {
  return server.session().ending() ? server.session().ending()->reason : "";
}

// For what goes on in the same way.
std::chrono::milliseconds enough() { return std::chrono::milliseconds(repetitions(6000)); }

void sendWelcome(HostileServer& server) { server.send(Welcome{0, 1, kHash, kMaxPlayers, kTicksPerSecond, ""}); }

// Sends chunks in order, again and again, as fast as the client takes them.
template <class Chunk>
void sendChunks(HostileServer& server, Chunk& next) {
  while (server.send(next)) next.offset = (next.offset + kChunk) % next.total;
}

TEST(HostileServer, ALevelOfTheLargestSizeThatIsNoneEndsTheSession) {
  HostileServer server;
  LevelChunk next = levelChunk();
  server.run([&](HostileServer& to) {
    if (to.call() == 0) sendWelcome(to);
    sendChunks(to, next);
  });
  EXPECT_EQ(reasonOf(server), "protocol error: invalid level from the server");
  EXPECT_LE(server.heapGrowth(), 24 * kMegabyte);
}

TEST(HostileServer, ALevelThatIsNeverCompleteCostsItsBytesOnly) {
  HostileServer server;
  server.run([](HostileServer& to) {
    if (to.call() == 0) sendWelcome(to);
    LevelChunk chunk = levelChunk();
    while (to.send(chunk)) chunk.offset = (chunk.offset + 3 * kChunk) % kMaxLevelBytes;
  });
  EXPECT_EQ(reasonOf(server), "");
  EXPECT_LE(server.heapGrowth(), kMegabyte);
}

TEST(HostileServer, StatesWithoutEndCostTheirLargestSizeOnly) {
  HostileServer server;
  StateChunk next{1, 7, 1, kMaxStateBytes, 0, Bytes(kChunk, 'x')};
  server.run([&](HostileServer& to) {
    if (to.call() == 0) return to.welcome();
    sendChunks(to, next);
  });
  EXPECT_EQ(reasonOf(server), "");
  EXPECT_LE(server.heapGrowth(), 8 * kMegabyte);
}

TEST(HostileServer, DesyncsWithoutEndAreCountedAndNotKept) {
  HostileServer server;
  server.run([](HostileServer& to) {
    if (to.call() == 0) return to.welcome();
    if (to.call() % 16 != 0) return;
    const Round* const round = to.session().round();
    const std::uint32_t confirmed = round == nullptr ? 0 : round->prediction().confirmedTicks();
    to.send(ConfirmedTicks{1, confirmed, 1, to.call(), {}, {}});
  });
  EXPECT_EQ(reasonOf(server), "");
  EXPECT_GE(server.session().roundStatistics().desyncs, 1u);
  EXPECT_LE(server.heapGrowth(), 8 * kMegabyte);
}

TEST(HostileServer, RostersWithoutEndAreNamesOfSlots) {
  HostileServer server;
  std::mt19937 random(1);
  server.run(enough(), [&](HostileServer& to) {
    if (to.call() == 0) sendWelcome(to);
    Roster roster;
    for (std::size_t i = 0; i < kMaxRosterEntries; ++i) {
      roster.entries.push_back({static_cast<std::uint32_t>(random() % kMaxPlayers), std::string(kMaxNameBytes, 'n')});
    }
    while (to.send(roster)) {
    }
  });
  EXPECT_EQ(reasonOf(server), "");
  EXPECT_EQ(server.session().names().size(), kMaxPlayers);
  EXPECT_LE(server.heapGrowth(), kMegabyte);
}

TEST(HostileServer, RoundTripsWithoutEndAreThoseOfSlots) {
  HostileServer server;
  server.run(enough(), [&](HostileServer& to) {
    if (to.call() == 0) sendWelcome(to);
    for (int i = 0; i < 100; ++i) to.send(false, encode(RoundTrips{std::vector<std::uint8_t>(kMaxPlayers, 255)}));
  });
  EXPECT_EQ(reasonOf(server), "");
  EXPECT_LE(server.heapGrowth(), kMegabyte);
}

HostileServer::Attack roundsWithoutEnd() {
  return [](HostileServer& to) {
    if (to.call() == 0) to.welcome();
    std::uint32_t round = 1000 * to.call();
    while (to.send(RoundEnd{round, 1, round + 1}) && to.send(RoundStart{round + 1, round + 2})) round += 2;
  };
}

// Their requests would pile up.
TEST(HostileServer, LevelsThatAreNamedAndNotSentEndTheSession) {
  HostileServer server;
  server.run(roundsWithoutEnd());
  EXPECT_EQ(reasonOf(server), "protocol error: the server names levels that it does not send");
  EXPECT_LE(server.heapGrowth(), kMegabyte);
}

TEST(HostileServer, RoundsWithoutEndCostNoMemory) {
  HostileServer server;
  server.run([](HostileServer& to) {
    if (to.call() == 0) return to.welcome();
    if (to.session().round() != nullptr)
      to.send(RoundStart{1 + to.call(), to.session().round()->prediction().confirmed().level().hash});
  });
  EXPECT_EQ(reasonOf(server), "");
  EXPECT_LE(server.heapGrowth(), kMegabyte);
}

TEST(HostileServer, AMalformedMessageEndsTheSession) {
  HostileServer server;
  server.run([](HostileServer& to) { to.send(true, Bytes{1, 2, 3}); });
  EXPECT_EQ(reasonOf(server), "protocol error: malformed message from the server");
}

TEST(HostileServer, ASilentServerEndsTheSession) {
  HostileServer server;
  server.run([](HostileServer& to) {
    if (to.call() == 0) to.welcome();
  });
  EXPECT_EQ(reasonOf(server), "connection timed out");
}

// 557 MB in two seconds, before they were checked.
TEST(HostileServer, ContentsThatNoServerSendsCostNoMemory) {
  HostileServer server;
  std::uint32_t number = 0;
  server.run([&](HostileServer& to) {
    if (to.call() == 0) to.welcome();
    for (int i = 0; i < 20; ++i, ++number) {
      const auto session =
          static_cast<std::uint16_t>(number / kHostileContents % 4 << ENET_PROTOCOL_HEADER_SESSION_SHIFT);
      to.sendContent(hostileContent(session, number));
    }
    if (to.call() % 64 == 0) to.send(Roster{});
  });
  EXPECT_EQ(reasonOf(server), "");
  EXPECT_TRUE(server.isConnected());
  EXPECT_LE(server.heapGrowth(), kMegabyte);
}

// One empty datagram hid all that came after it.
TEST(HostileServer, DatagramsThatAreNoneDisturbNothing) {
  HostileServer server;
  std::mt19937 random(1);
  server.run([&](HostileServer& to) {
    if (to.call() == 0) to.welcome();
    for (int i = 0; i < 20; ++i) {
      Bytes datagram(i % 2 == 0 ? 0 : random() % 1500);
      for (std::uint8_t& byte : datagram) byte = static_cast<std::uint8_t>(random());
      to.sendDatagram(datagram);
    }
    if (to.call() % 16 == 0) to.send(Roster{});
  });
  EXPECT_EQ(reasonOf(server), "");  // it received the rosters, or it would have timed out
  EXPECT_TRUE(server.isConnected());
  EXPECT_LE(server.heapGrowth(), kMegabyte);
}

TEST(HostileServer, TicksWithoutEndCostNoMemory) {
  HostileServer server;
  server.run(enough(), [](HostileServer& to) {
    if (to.call() == 0) return to.welcome();
    const Round* const round = to.session().round();
    if (round == nullptr) return;
    const std::uint32_t confirmed = round->prediction().confirmedTicks();
    to.send(ConfirmedTicks{1, confirmed, kMaxTicksPerMessage, 1, {}, {}});
  });
  EXPECT_LE(server.heapGrowth(), 32 * kMegabyte);
}

constexpr const char* kDemanding = "protocol error: the server demands more computation than a game needs";

// Counts what a client computes between two calls of an attack.
class WorkMeter {
 public:
  void look(const Prediction& prediction) {
    if (work_ != 0) mostWork = std::max(mostWork, prediction.work() - work_);
    mostConfirmed = std::max(mostConfirmed, prediction.confirmedTicks() - confirmed_);
    work_ = prediction.work();
    confirmed_ = prediction.confirmedTicks();
  }

  std::uint64_t mostWork = 0;
  std::uint32_t mostConfirmed = 0;

 private:
  std::uint64_t work_ = 0;
  std::uint32_t confirmed_ = 0;
};

// Twice the ticks that a client takes in a frame.
TEST(HostileServer, TicksWithoutEndAreLimitedInAFrameAndEndTheSession) {
  constexpr std::uint32_t kTicks = 2 * Round::kMaxWorkConfirmed;
  HostileServer server;
  WorkMeter meter;
  server.run([&](HostileServer& to) {
    if (to.call() == 0) return to.welcome();
    const Round* const round = to.session().round();
    if (round == nullptr) return;
    meter.look(round->prediction());
    std::uint32_t tick = round->prediction().confirmedTicks();
    for (const std::uint32_t end = tick + kTicks; tick < end; tick += kMaxTicksPerMessage) {
      to.send(ConfirmedTicks{1, tick, kMaxTicksPerMessage, 1, {}, {}});
    }
  });
  EXPECT_EQ(reasonOf(server), kDemanding);
  EXPECT_EQ(meter.mostConfirmed, Round::kMaxWorkConfirmed);  // a tick without players counts as one
  EXPECT_LE(meter.mostWork, Round::kMaxWorkConfirmed + Prediction::kMaxAhead);
  // The budget of the session lasts for so many frames of a millisecond.
  EXPECT_EQ(server.call() / 100, 7u);
}

// Each tick says that the other 255 players have changed their buttons, so that the client predicts again.
TEST(HostileServer, ReplaysWithoutEndAreLimitedInAFrameAndEndTheSession) {
  HostileServer server;
  WorkMeter meter;
  server.run([&](HostileServer& to) {
    if (to.call() == 0) return to.welcome();
    const Round* const round = to.session().round();
    if (round == nullptr) return;
    meter.look(round->prediction());
    ConfirmedTicks message{1, round->prediction().confirmedTicks(), 1, 1, {}, {}};
    const auto buttons = static_cast<std::uint8_t>(Input::kPresent | (to.call() % 2 == 0 ? Input::kLeft : 0));
    for (std::uint32_t slot = 1; slot < kMaxPlayers; ++slot) {
      message.changes.push_back({message.from, slot, Input{buttons}});
    }
    for (int i = 0; i < 100; ++i, ++message.from) {
      for (InputChange& change : message.changes) change.tick = message.from;
      to.send(message);
    }
  });
  EXPECT_EQ(reasonOf(server), kDemanding);
  // One replay, and one tick more than fits.
  EXPECT_LE(meter.mostWork, Round::kMaxWorkConfirmed + kMaxPlayers + 2 * Prediction::kMaxWorkAhead);
}

}  // namespace
}  // namespace platon::hostile_server_test
