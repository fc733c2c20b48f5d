#include "server/admin/metrics.h"

#include <map>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "protocol/program_error.h"
#include "protocol/transport/socket_address.h"
#include "server/admin/stream_socket.h"
#include "tests/server/metrics_reader.h"
#include "tests/support/wait_until.h"

namespace platon::metrics_test {
namespace {

TEST(MetricsText, IsInTheFormatOfPrometheus) {
  const std::vector<Metric> metrics{
      {"platon_info",
       "gauge",
       "Name.",
       {{"1", {{"version", "0.1.0"}, {"name", "Our \"best\" \\server\\\nof all, Zoë"}}, {}}}},
      {"platon_tick_seconds",
       "summary",
       "Ticks.",
       {{secondsText(99), {{"quantile", "0.5"}}, {}},
        {secondsText(3'600'000'001), {}, "_sum"},
        {"1000", {}, "_count"}}},
      {"platon_sent_bytes_total", "counter", "Bytes.", {{"18446744073709551615", {}, {}}}}};
  const MetricsReader text(formatMetrics(metrics));
  EXPECT_EQ(text.types,
            (std::map<std::string, std::string>{
                {"platon_info", "gauge"}, {"platon_tick_seconds", "summary"}, {"platon_sent_bytes_total", "counter"}}));
  EXPECT_EQ(text.helps.at("platon_info"), "Name.");
  EXPECT_EQ(text.values, (std::map<std::string, std::string>{
                             {R"(platon_info{version="0.1.0",name="Our \"best\" \\server\\\nof all, Zoë"})", "1"},
                             {R"(platon_tick_seconds{quantile="0.5"})", "0.000099"},
                             {"platon_tick_seconds_sum", "3600.000001"},
                             {"platon_tick_seconds_count", "1000"},
                             {"platon_sent_bytes_total", "18446744073709551615"}}));
}

TEST(MetricsText, SecondsAreExact) {
  EXPECT_EQ(secondsText(0), "0.000000");
  EXPECT_EQ(secondsText(1'234'567), "1.234567");
  EXPECT_EQ(secondsText(18'446'744'073'709'551'615u), "18446744073709.551615");
}

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

using namespace std::chrono_literals;

SocketAddress address(const std::string& text) { return parseSocketAddress(text).value(); }

Descriptor connectTcp(const SocketAddress& to) {
  SystemAddress system;
  const socklen_t length = toSystem(to, !to.ip.isIpv4(), system);
  Descriptor socket(::socket(system.any.sa_family, SOCK_STREAM | SOCK_CLOEXEC, 0));
  EXPECT_EQ(connect(socket.number(), &system.any, length), 0);
  return socket;
}

/// A server on loopback, in virtual time.
class MetricsServerTest : public testing::Test {
 protected:
  void poll() {
    server_.poll(now_, [this] {
      ++pages_;
      return page_;
    });
  }

  // What arrives until the server closes the connection.
  std::string receiveAll(const Descriptor& socket) {
    std::string all;
    const auto step = [this] { poll(); };
    EXPECT_TRUE(stepUntil(step, [&] {
      Received received = receiveFrom(socket);
      for (; !received.bytes.empty(); received = receiveFrom(socket)) all += received.bytes;
      return received.closed;
    }));
    return all;
  }

  std::string get(const std::string& request) {
    const Descriptor socket = connectTcp(server_.address());
    std::string bytes = request;
    EXPECT_TRUE(sendTo(socket, bytes));
    return receiveAll(socket);
  }

  // Polls until the server has as many connections.
  bool reaches(std::size_t connections) {
    return stepUntil([this] { poll(); }, [&] { return server_.connections() == connections; });
  }

  MetricsServer server_{address("127.0.0.1:0")};
  TimePoint now_{};
  std::string page_ = "a 1\n";
  int pages_ = 0;
};

TEST(SocketAddressText, IsAnAddressAndAPort) {
  EXPECT_EQ(address("127.0.0.1:19777").text(), "127.0.0.1:19777");
  EXPECT_EQ(address("[::1]:0").text(), "[::1]:0");
  EXPECT_EQ(address("[2001:db8::1]:65535").text(), "[2001:db8::1]:65535");
  for (const std::string text : {"", ":", "19777", "127.0.0.1", "127.0.0.1:", ":19777", "::1:19777", "[::1]",
                                 "[::1]:", "[127.0.0.1]:1", "localhost:19777", "127.0.0.1:65536", "127.0.0.1:-1",
                                 "127.0.0.1:+1", "127.0.0.1:1x", "[::1:19777", "[]:1", "127.0.0.1 :1"}) {
    EXPECT_FALSE(parseSocketAddress(text)) << text;
  }
  EXPECT_FALSE(parseSocketAddress(std::string_view("127.0.0.1\0:1", 12)));
}

TEST_F(MetricsServerTest, AnswersTheMetrics) {
  EXPECT_EQ(get("GET /metrics HTTP/1.1\r\nHost: a\r\n\r\n"),
            httpResponse(HttpStatus::kOk, "text/plain; version=0.0.4", "a 1\n"));
  page_ = "a 2\n";
  EXPECT_TRUE(get("GET /metrics HTTP/1.0\r\n\r\n").ends_with("\r\n\r\na 2\n"));
  EXPECT_EQ(pages_, 2);
}

TEST_F(MetricsServerTest, AnswersOtherRequestsWithAnError) {
  EXPECT_TRUE(get("GET / HTTP/1.1\r\n\r\n").starts_with("HTTP/1.1 404 "));
  EXPECT_TRUE(get("POST /metrics HTTP/1.1\r\nContent-Length: 3\r\n\r\nabc").starts_with("HTTP/1.1 405 "));
  EXPECT_TRUE(get("\x16\x03\x01\r\n\r\n").starts_with("HTTP/1.1 400 "));
  EXPECT_TRUE(get("GET /metrics HTTP/1.1\r\n" + std::string(kMaxHttpHeadBytes, 'x')).starts_with("HTTP/1.1 431 "));
  EXPECT_EQ(pages_, 0);
}

// A server that closes with bytes unread resets the connection, and the answer may be lost.
TEST_F(MetricsServerTest, AnAnswerIsNotLostWhenTheBodyOfTheRequestIsLong) {
  const Descriptor socket = connectTcp(server_.address());
  std::string head = "POST /metrics HTTP/1.1\r\nContent-Length: 100000\r\n\r\n";
  EXPECT_TRUE(sendTo(socket, head));
  std::string body(100'000, 'x');
  std::string answer;
  const auto step = [&] {
    poll();
    sendTo(socket, body);
  };
  EXPECT_TRUE(stepUntil(step, [&] {
    answer += receiveFrom(socket).bytes;
    return body.empty() && answer.ends_with("Method Not Allowed\n");
  }));
}

TEST_F(MetricsServerTest, SendsALongPage) {
  page_ = std::string(8 * 1024 * 1024, 'x');
  const std::string answer = get("GET /metrics HTTP/1.1\r\n\r\n");
  EXPECT_EQ(answer.size() - answer.find("\r\n\r\n") - 4, page_.size());
}

TEST_F(MetricsServerTest, DropsAConnectionThatTakesTooLong) {
  page_ = std::string(32 * 1024 * 1024, 'x');
  const Descriptor silent = connectTcp(server_.address());
  const Descriptor reader = connectTcp(server_.address());
  std::string request = "GET /metrics HTTP/1.1\r\n\r\n";
  EXPECT_TRUE(sendTo(reader, request));
  EXPECT_TRUE(stepUntil([this] { poll(); }, [this] { return pages_ == 1; }));
  now_ += MetricsServer::kConnectionTime;
  poll();
  EXPECT_EQ(server_.connections(), 2u);
  now_ += 1ms;
  poll();
  EXPECT_EQ(server_.connections(), 0u);
}

TEST_F(MetricsServerTest, TheOldestConnectionThatHasNotAskedEndsForAnother) {
  page_ = std::string(32 * 1024 * 1024, 'x');
  std::vector<Descriptor> sockets;
  sockets.push_back(connectTcp(server_.address()));
  std::string request = "GET /metrics HTTP/1.1\r\n\r\n";
  EXPECT_TRUE(sendTo(sockets[0], request));
  EXPECT_TRUE(stepUntil([this] { poll(); }, [this] { return pages_ == 1; }));
  while (sockets.size() < MetricsServer::kMaxConnections + 3) {
    sockets.push_back(connectTcp(server_.address()));
    poll();
  }
  EXPECT_TRUE(stepUntil([this] { poll(); }, [&] { return receiveFrom(sockets[3]).closed; }));
  EXPECT_EQ(server_.connections(), MetricsServer::kMaxConnections);
  EXPECT_TRUE(receiveFrom(sockets[1]).closed && receiveFrom(sockets[2]).closed);
  EXPECT_FALSE(receiveFrom(sockets[0]).closed || receiveFrom(sockets[4]).closed || receiveFrom(sockets.back()).closed);
}

TEST_F(MetricsServerTest, TheOldestConnectionEndsForAnotherIfAllHaveAsked) {
  std::vector<Descriptor> sockets;
  for (std::size_t i = 0; i < MetricsServer::kMaxConnections + 1; ++i) {
    sockets.push_back(connectTcp(server_.address()));
    std::string request = "GET /metrics HTTP/1.1\r\n\r\n";
    EXPECT_TRUE(sendTo(sockets.back(), request));
    EXPECT_TRUE(stepUntil([this] { poll(); }, [&] { return pages_ == static_cast<int>(i) + 1; }));
  }
  EXPECT_EQ(server_.connections(), MetricsServer::kMaxConnections) << "they wait for the other end to close";
}

// It waited for the end of their time, one after the other.
TEST_F(MetricsServerTest, AScrapeDoesNotWaitForThoseWhoConnectAndSayNothing) {
  std::vector<Descriptor> sockets;
  for (int i = 0; i < 40; ++i) {
    sockets.push_back(connectTcp(server_.address()));
    if (i % 4 == 3) poll();
  }
  EXPECT_TRUE(get("GET /metrics HTTP/1.1\r\n\r\n").ends_with(page_));
  EXPECT_EQ(now_, TimePoint{});
}

TEST_F(MetricsServerTest, AClosedConnectionIsForgotten) {
  {
    const Descriptor socket = connectTcp(server_.address());
    EXPECT_TRUE(reaches(1));
  }
  EXPECT_TRUE(reaches(0));
}

TEST(MetricsServer, ListensOnIpv6) {
  if (!listenTcp(address("[::1]:0"))) GTEST_SKIP() << "this machine has no IPv6";
  MetricsServer server(address("[::1]:0"));
  const Descriptor socket = connectTcp(server.address());
  std::string request = "GET /metrics HTTP/1.1\r\n\r\n";
  EXPECT_TRUE(sendTo(socket, request));
  std::string answer;
  EXPECT_TRUE(stepUntil([&] { server.poll(TimePoint(), [] { return std::string("six 6\n"); }); },
                        [&] {
                          answer += receiveFrom(socket).bytes;
                          return answer.ends_with("six 6\n");
                        }));
}

TEST(MetricsServer, SaysWhyItCannotListen) {
  const auto errorOf = [](const SocketAddress& at, int exitCode) -> std::string {
    try {
      const MetricsServer server(at);
      return "none";
    } catch (const ProgramError& error) {
      EXPECT_EQ(error.exitCode(), exitCode);
      return error.what();
    }
  };
  const MetricsServer first(address("127.0.0.1:0"));
  EXPECT_EQ(errorOf(first.address(), ProgramError::kFailed),
            "cannot serve metrics on " + first.address().text() +
                ": Address already in use; stop the program that uses it or choose another port after --metrics");
  EXPECT_EQ(errorOf(address("198.51.100.1:19777"), ProgramError::kUsage),
            "cannot serve metrics on 198.51.100.1:19777: Cannot assign requested address; choose an address of this "
            "machine after --metrics");
}

}  // namespace
}  // namespace platon::metrics_test
