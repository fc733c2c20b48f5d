#include "server/admin/http.h"

#include <gtest/gtest.h>

#include <random>

namespace platon::http_test {
namespace {

std::optional<HttpStatus> answer(const std::string& received) { return answerTo(received, "/metrics"); }

TEST(Http, AnswersTheOnePage) {
  EXPECT_EQ(answer("GET /metrics HTTP/1.1\r\nHost: a\r\n\r\n"), HttpStatus::kOk);
  EXPECT_EQ(answer("GET /metrics HTTP/1.0\r\n\r\n"), HttpStatus::kOk);
  EXPECT_EQ(answer("GET /metrics?x=/y HTTP/1.1\r\n\r\n"), HttpStatus::kOk);
}

TEST(Http, WaitsForTheWholeHead) {
  const std::string request = "GET /metrics HTTP/1.1\r\nHost: a\r\n\r\n";
  for (std::size_t length = 0; length < request.size(); ++length)
    EXPECT_EQ(answer(request.substr(0, length)), std::nullopt);
}

TEST(Http, RefusesEverythingElse) {
  EXPECT_EQ(answer("GET / HTTP/1.1\r\n\r\n"), HttpStatus::kNotFound);
  EXPECT_EQ(answer("GET /metrics/ HTTP/1.1\r\n\r\n"), HttpStatus::kNotFound);
  EXPECT_EQ(answer("POST /other HTTP/1.1\r\n\r\n"), HttpStatus::kNotFound);
  EXPECT_EQ(answer("POST /metrics HTTP/1.1\r\n\r\nabc"), HttpStatus::kMethodNotAllowed);
  EXPECT_EQ(answer("HEAD /metrics HTTP/1.1\r\n\r\n"), HttpStatus::kMethodNotAllowed);
  for (const char* line : {"", "GET", "GET /metrics", "GET  HTTP/1.1", "GET /metrics HTTP/2.0", "GET metrics HTTP/1.1",
                           "get /metrics HTTP/1.1", "GET /metrics  HTTP/1.1", "GET /metrics x HTTP/1.1",
                           "GET /met\x01rics HTTP/1.1", "GET /metrics\xc3\xaf HTTP/1.1", "G\tET /metrics HTTP/1.1"}) {
    EXPECT_EQ(answer(std::string(line) + "\r\n\r\n"), HttpStatus::kBadRequest) << line;
  }
}

TEST(Http, RefusesAHeadThatIsTooLong) {
  const auto head = [](std::size_t bytes) { return "GET /metrics HTTP/1.1\r\nX: " + std::string(bytes - 26, 'x'); };
  EXPECT_EQ(answer(head(kMaxHttpHeadBytes)), std::nullopt);
  EXPECT_EQ(answer(head(kMaxHttpHeadBytes) + "\r\n\r\n"), HttpStatus::kOk);
  EXPECT_EQ(answer(head(kMaxHttpHeadBytes + 1) + "\r\n\r\n"), HttpStatus::kHeadTooLarge);
  EXPECT_EQ(answer(head(kMaxHttpHeadBytes + 5)), HttpStatus::kHeadTooLarge);
}

TEST(Http, EveryCompleteHeadHasAnAnswer) {
  const std::string bytes = "GET /metrics HTTP/1.\r\n ?x\x80";
  std::mt19937 random(3);
  for (int i = 0; i < 20000; ++i) {
    std::string request;
    for (std::size_t length = random() % 40; length > 0; --length) request += bytes[random() % bytes.size()];
    EXPECT_TRUE(answer(request + "\r\n\r\n").has_value());
  }
}

TEST(Http, AResponseSaysHowLongItIs) {
  EXPECT_EQ(
      httpResponse(HttpStatus::kOk, "text/plain; version=0.0.4", "abc\n"),
      "HTTP/1.1 200 OK\r\nContent-Type: text/plain; version=0.0.4\r\nContent-Length: 4\r\nConnection: close\r\n\r\n"
      "abc\n");
  EXPECT_EQ(httpResponse(HttpStatus::kNotFound, "x", "y"),
            "HTTP/1.1 404 Not Found\r\nContent-Type: text/plain\r\nContent-Length: 10\r\nConnection: close\r\n\r\n"
            "Not Found\n");
  EXPECT_NE(httpResponse(HttpStatus::kMethodNotAllowed, "x", "y").find("405 Method Not Allowed\r\nAllow: GET\r\n"),
            std::string::npos);
}

}  // namespace
}  // namespace platon::http_test
