// What clients can use up, and those who try.
#include <gtest/gtest.h>

#include "server/net/host.h"
#include "tests/server/net/host_fixture.h"

namespace platon::host_limits_test {
namespace {

using namespace std::chrono_literals;

class HostLimitsTest : public HostTest {};

// 10 800 connections a second were free: ENet ends one that is not confirmed without an event.
TEST_F(HostLimitsTest, ASessionWhoseConnectionHasEndedGetsNoOther) {
  eve_.join(host_, now_);
  eve_.send(connectContent(77), now_);
  eve_.step(host_, now_);
  for (std::uint32_t id = 100; id < 110; ++id) {
    eve_.send(disconnectContent(eve_.peer()), now_);
    eve_.send(connectContent(id), now_);
  }
  host_.service(now_);
  EXPECT_EQ(host_.counters().content, 10u);
  EXPECT_TRUE(host_.empty());
  const std::uint64_t before = host_.gate().counters().seal;
  eve_.send(connectContent(200), now_);
  host_.service(now_);
  EXPECT_EQ(host_.gate().counters().seal, before + 1) << "the session has ended too";
}

TEST_F(HostLimitsTest, ARequestToConnectIsChargedToItsConnection) {
  eve_.join(host_, now_);
  for (int i = 0; i < 301; ++i) eve_.send(connectContent(77), now_);
  host_.service(now_);
  EXPECT_EQ(host_.counters().excess, 1u);
}

// It began with the budget that the one before had used up.
TEST_F(HostLimitsTest, AConnectionInheritsNothingOfTheOneBeforeInItsPlace) {
  HostileClient mallory(network_, addressAt("192.0.2.67", 4000), kServer);
  mallory.join(host_, now_);
  eve_.join(host_, now_);
  eve_.send(connectContent(77), now_);
  eve_.step(host_, now_);
  for (int i = 0; i < 299; ++i) eve_.send(pingContent(eve_.peer()), now_);
  host_.service(now_);
  EXPECT_EQ(host_.counters().excess, 0u);
  now_ += 10ms;
  eve_.send(disconnectContent(eve_.peer()), now_);
  mallory.send(connectContent(78), now_);
  mallory.step(host_, now_);
  for (int i = 0; i < 290; ++i) mallory.send(pingContent(mallory.peer()), now_);
  host_.service(now_);
  EXPECT_EQ(host_.counters().excess, 0u);
  EXPECT_EQ(mallory.peer() & ENET_PROTOCOL_MAXIMUM_PEER_ID, eve_.peer() & ENET_PROTOCOL_MAXIMUM_PEER_ID);
}

}  // namespace
}  // namespace platon::host_limits_test
