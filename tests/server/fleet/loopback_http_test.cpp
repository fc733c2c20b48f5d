#include "server/fleet/loopback_http.h"

#include <gtest/gtest.h>

#include "server/fleet/agones_call.h"
#include "tests/server/fleet/fake_sidecar.h"
#include "tests/support/wait_until.h"

namespace platon::loopback_http_test {
namespace {

using namespace std::chrono_literals;

class LoopbackHttpTest : public testing::Test {
 protected:
  std::optional<std::string> send(const std::string& request) { return answerTo(request, LoopbackPart::kStatus).fault; }

  LoopbackAnswer answerTo(const std::string& request, LoopbackPart part) {
    return sendOverLoopback(request, sidecar_.port(), part, 60s, [] { return std::chrono::steady_clock::now(); });
  }

  std::optional<std::string> lastAllocationOf(const std::string& request) {
    return lastAllocation(answerTo(request, LoopbackPart::kBody).body);
  }

  // Waits for the answer for 20 ms, and as long as needed until the request is sent: the clock stands still.
  std::optional<std::string> sendWithoutPatience(const std::string& request) {
    return sendOverLoopback(request, sidecar_.port(), LoopbackPart::kStatus, 20ms, [] { return TimePoint(); }).fault;
  }

  std::string request(AgonesCall call) const { return agonesRequest(call, sidecar_.port(), {3, 16}); }

  FakeSidecar sidecar_;
};

TEST_F(LoopbackHttpTest, TheSidecarTakesEveryCall) {
  for (const AgonesCall call : {AgonesCall::kReady, AgonesCall::kHealth, AgonesCall::kAllocate, AgonesCall::kPlayers,
                                AgonesCall::kGameServer, AgonesCall::kShutdown}) {
    EXPECT_EQ(send(request(call)), std::nullopt) << nameOf(call);
  }
  EXPECT_EQ(sidecar_.calls(),
            (std::vector<std::string>{"POST /ready {}", "POST /health {}", "POST /allocate {}",
                                      "PATCH /v1beta1/counters/players {\"count\":\"3\",\"capacity\":\"16\"}",
                                      "GET /gameserver ", "POST /shutdown {}"}));
  EXPECT_EQ(sidecar_.faults(), std::vector<std::string>{});
}

TEST_F(LoopbackHttpTest, EachAllocationOfTheGameServerIsSeen) {
  const std::string look = request(AgonesCall::kGameServer);
  EXPECT_EQ(lastAllocationOf(look), "");
  send(request(AgonesCall::kAllocate));
  const auto own = lastAllocationOf(look);
  sidecar_.allocate();
  const auto fleets = lastAllocationOf(look);
  EXPECT_NE(own, "");
  EXPECT_NE(fleets, own);
  send(request(AgonesCall::kReady));
  EXPECT_EQ(lastAllocationOf(look), fleets);
}

TEST_F(LoopbackHttpTest, ARefusalIsReported) {
  sidecar_.set(FakeSidecar::Mode::kRefuses);
  EXPECT_EQ(send(request(AgonesCall::kReady)), "it answers with HTTP status 500");
  sidecar_.set(FakeSidecar::Mode::kAnswers);
  EXPECT_EQ(send("GET /nothing HTTP/1.1\r\n\r\n"), "it answers with HTTP status 400");
  EXPECT_EQ(sidecar_.faults(), std::vector<std::string>{"there is no GET /nothing"});
}

TEST_F(LoopbackHttpTest, MorePlayersThanPlacesAreRefused) {
  EXPECT_EQ(send(agonesRequest(AgonesCall::kPlayers, sidecar_.port(), {17, 16})), "it answers with HTTP status 400");
  EXPECT_EQ(sidecar_.faults(), std::vector<std::string>{"17 players are out of range"});
}

TEST_F(LoopbackHttpTest, ASilentSidecarIsNotWaitedForLonger) {
  sidecar_.set(FakeSidecar::Mode::kIsSilent);
  EXPECT_EQ(sendWithoutPatience(request(AgonesCall::kReady)), "it does not answer in time");
}

TEST_F(LoopbackHttpTest, ALateAnswerIsAFailureOfACallThatTookEffect) {
  sidecar_.set(FakeSidecar::Mode::kIsLate);
  EXPECT_EQ(sendWithoutPatience(request(AgonesCall::kAllocate)), "it does not answer in time");
  EXPECT_TRUE(waitUntil([&] { return sidecar_.count("POST /allocate") == 1; }));
  EXPECT_EQ(send(request(AgonesCall::kAllocate)), std::nullopt);
  EXPECT_EQ(sidecar_.count("POST /allocate"), 2u);
}

TEST_F(LoopbackHttpTest, AMissingSidecarIsReportedAndFoundAgain) {
  sidecar_.vanish();
  EXPECT_EQ(send(request(AgonesCall::kReady)), "Connection refused");
  sidecar_.comeBack();
  EXPECT_EQ(send(request(AgonesCall::kReady)), std::nullopt);
}

}  // namespace
}  // namespace platon::loopback_http_test
