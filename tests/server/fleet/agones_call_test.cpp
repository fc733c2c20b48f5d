#include "server/fleet/agones_call.h"

#include <gtest/gtest.h>

#include "protocol/program_error.h"
#include "tests/server/fleet/fake_sidecar.h"
#include "tests/support/wait_until.h"

namespace platon::agones_call_test {
namespace {

TEST(AgonesPort, IsThatOfTheVariable) {
  EXPECT_EQ(agonesPortOf(nullptr), std::nullopt);
  EXPECT_EQ(agonesPortOf(""), std::nullopt);
  EXPECT_EQ(agonesPortOf("9358"), 9358);
  EXPECT_EQ(agonesPortOf("65535"), 65535);
}

TEST(AgonesPort, AnythingElseIsRefused) {
  for (const char* value : {"0", "65536", "-1", "9358 ", "http", "1.5"}) {
    EXPECT_THROW(agonesPortOf(value), ProgramError) << value;
  }
  try {
    agonesPortOf("x");
  } catch (const ProgramError& error) {
    EXPECT_EQ(error.exitCode(), ProgramError::kUsage);
    EXPECT_STREQ(error.what(),
                 "AGONES_SDK_HTTP_PORT must be a port from 1 to 65535, not 'x'; unset it to run without Agones");
  }
}

TEST(AgonesCall, ACallWithoutContentPostsAnEmptyObject) {
  EXPECT_EQ(agonesRequest(AgonesCall::kReady, 9358, {}),
            "POST /ready HTTP/1.1\r\nHost: localhost:9358\r\nContent-Type: application/json\r\nContent-Length: 2\r\n"
            "Connection: close\r\n\r\n{}");
  EXPECT_TRUE(agonesRequest(AgonesCall::kHealth, 1, {}).starts_with("POST /health HTTP/1.1\r\n"));
  EXPECT_TRUE(agonesRequest(AgonesCall::kAllocate, 1, {}).starts_with("POST /allocate HTTP/1.1\r\n"));
  EXPECT_TRUE(agonesRequest(AgonesCall::kShutdown, 1, {}).starts_with("POST /shutdown HTTP/1.1\r\n"));
}

TEST(AgonesCall, ThePlayersReplaceTheCounter) {
  const std::string request = agonesRequest(AgonesCall::kPlayers, 9358, {3, 16});
  EXPECT_TRUE(request.starts_with("PATCH /v1beta1/counters/players HTTP/1.1\r\n")) << request;
  EXPECT_TRUE(
      request.ends_with("\r\nContent-Length: 29\r\nConnection: close\r\n\r\n{\"count\":\"3\",\"capacity\":\"16\"}"))
      << request;
}

// In one piece: an answer to HTTP/1.1 may come in chunks.
TEST(AgonesCall, TheGameServerIsAskedForByHttp10) {
  EXPECT_EQ(agonesRequest(AgonesCall::kGameServer, 9358, {}),
            "GET /gameserver HTTP/1.0\r\nHost: localhost:9358\r\n\r\n");
}

TEST(AgonesCall, TheLastAllocationIsAnAnnotation) {
  EXPECT_EQ(lastAllocation(R"({"object_meta":{"annotations":{"agones.dev/last-allocated":"2026-11-27T18:00:00.1Z"}}})"),
            "2026-11-27T18:00:00.1Z");
  EXPECT_EQ(lastAllocation(R"({"object_meta":{"annotations":{"agones.dev/sdk-version":"1.57.0"}}})"), "");
  EXPECT_EQ(lastAllocation(R"({"object_meta":{}})"), "");
}

TEST(AgonesCall, WhatDescribesNoGameServerHasNoAllocation) {
  for (const char* text :
       {"", "{", "[]", "{}", "null", R"({"object_meta":null})", R"({"object_meta":{"annotations":{"agones.dev/last-al)",
        R"({"object_meta":{"annotations":{"agones.dev/last-allocated":1}}})"}) {
    EXPECT_EQ(lastAllocation(text), std::nullopt) << text;
  }
}

TEST(AgonesCall, TheNamesForTheLogAreWords) {
  EXPECT_EQ(nameOf(AgonesCall::kReady), "ready");
  EXPECT_EQ(nameOf(AgonesCall::kPlayers), "players");
  EXPECT_EQ(nameOf(AgonesCall::kGameServer), "gameserver");
}

TEST(AgonesCall, TheStatusIsKnownOnceItsLineHasArrived) {
  EXPECT_EQ(statusOf(""), std::nullopt);
  EXPECT_EQ(statusOf("HTTP/1.1 200 OK"), std::nullopt);
  EXPECT_EQ(statusOf("HTTP/1.1 200 OK\r\n"), 200);
  EXPECT_EQ(statusOf("HTTP/1.0 404\r\nX: 1"), 404);
  EXPECT_EQ(statusOf("HTTP/1.1 500 \r\n\r\n"), 500);
}

TEST(AgonesCall, WhatIsNoHttpHasNoStatus) {
  for (const char* text : {"\r\n", "HTTP/2 200\r\n", "HTTP/1.1 2x0 OK\r\n", "HTTP/1.1 2000\r\n", "HTTP/1.1 99\r\n",
                           "HTTP/1.1 -20 OK\r\n", "HTTP/1.1  20 OK\r\n", "SSH-2.0\r\n"}) {
    EXPECT_EQ(statusOf(text), 0) << text;
  }
  EXPECT_EQ(statusOf(std::string(513, 'x')), 0);
}

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
}  // namespace platon::agones_call_test
