#include "server/fleet/agones_call.h"

#include <gtest/gtest.h>

namespace platon::agones_call_test {
namespace {

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

}  // namespace
}  // namespace platon::agones_call_test
