#include "client/lobby/download.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <vector>

#include "tests/client/lobby/web_server.h"

namespace platon::download_test {
namespace {

using testing::HasSubstr;

std::string faultOf(const std::string& url, std::size_t maxBytes = 1000, const std::stop_token& stop = {}) {
  try {
    return "no fault: " + download(url, maxBytes, stop);
  } catch (const DownloadError& error) {
    return error.what();
  }
}

TEST(DownloadTest, ReturnsTheContent) {
  const WebServer server([](std::string_view request) { return WebServer::ok("asked for " + std::string(request)); });
  EXPECT_EQ(download(server.url("/list"), 1000), "asked for GET /list HTTP/1.1");
}

TEST(DownloadTest, TheLengthIsBounded) {
  const WebServer server([](std::string_view) { return WebServer::ok(std::string(1001, 'x')); });
  EXPECT_EQ(download(server.url(), 1001).size(), 1001u);
  EXPECT_EQ(faultOf(server.url(), 1000), "it has more than 1000 bytes");
}

TEST(DownloadTest, NamesTheCauseOfAFailure) {
  const WebServer missing([](std::string_view) { return std::string("HTTP/1.1 404 Not Found\r\n\r\n"); });
  EXPECT_THAT(faultOf(missing.url()), HasSubstr("404"));
  const WebServer cut([](std::string_view) { return std::string("HTTP/1.1 200 OK\r\nContent-Length: 9\r\n\r\nab"); });
  EXPECT_THAT(faultOf(cut.url()), HasSubstr("remaining to read"));
  const WebServer silent([](std::string_view) { return std::string(); });
  EXPECT_THAT(faultOf(silent.url()), HasSubstr("Empty reply"));
  EXPECT_NE(faultOf("http://127.0.0.1:1/"), "");
}

TEST(DownloadTest, LeavesTheWebForNothing) {
  EXPECT_THAT(faultOf("file:///etc/hostname"), HasSubstr("not supported"));
  const WebServer sly([](std::string_view) {
    return std::string("HTTP/1.1 302 Found\r\nLocation: file:///etc/hostname\r\nContent-Length: 0\r\n\r\n");
  });
  EXPECT_THAT(faultOf(sly.url()), HasSubstr("not supported"));
  const WebServer round([](std::string_view) {
    return std::string("HTTP/1.1 302 Found\r\nLocation: /again\r\nContent-Length: 0\r\n\r\n");
  });
  EXPECT_THAT(faultOf(round.url()), HasSubstr("redirects"));
}

TEST(DownloadTest, TheInternetLeadsToNoPrivateAddressAndANetworkNotToThisMachine) {
  const auto ip = [](const char* text) { return *IpAddress::parse(text); };
  const std::vector<const char*> kOwn{"127.0.0.1", "127.8.8.8", "::1", "0.0.0.0", "::"};
  const std::vector<const char*> kNear{"192.168.1.1", "10.0.0.1", "fd00::1", "169.254.1.1"};
  const std::vector<const char*> kFar{"198.51.100.1", "2001:db8::1"};
  const std::vector<std::vector<const char*>> kinds{kOwn, kNear, kFar};
  for (std::size_t from = 0; from < kinds.size(); ++from) {
    for (std::size_t to = 0; to < kinds.size(); ++to) {
      for (const char* const source : kinds[from]) {
        for (const char* const target : kinds[to])
          EXPECT_EQ(mayRedirect(ip(source), ip(target)), to >= from) << source << " to " << target;
      }
    }
  }
}

// It made the client ask any port of the player's own machine.
TEST(DownloadTest, LeadsOnlyWhereItMay) {
  std::atomic<int> asked = 0;
  const WebServer target([&](std::string_view) {
    ++asked;
    return WebServer::ok("secret");
  });
  const WebServer sly([&](std::string_view) {
    return "HTTP/1.1 302 Found\r\nLocation: " + target.url("/delete") + "\r\nContent-Length: 0\r\n\r\n";
  });
  EXPECT_EQ(download(sly.url(), 1000), "secret") << "this machine may lead to itself";
  EXPECT_EQ(asked, 1);
  const auto never = [](const IpAddress& from, const IpAddress& to) {
    EXPECT_EQ(from, IpAddress::parse("127.0.0.1"));
    EXPECT_EQ(to, IpAddress::parse("127.0.0.1"));
    return false;
  };
  EXPECT_EQ(download(target.url(), 1000, {}, never), "secret") << "the URL itself may be anywhere";
  try {
    download(sly.url(), 1000, {}, never);
    ADD_FAILURE() << "it was followed";
  } catch (const DownloadError& error) {
    EXPECT_STREQ(
        error.what(),
        "it redirects to 127.0.0.1, an address of this machine or of a private network; only a list from there may");
  }
  EXPECT_EQ(asked, 2);
}

// A proxy on this machine fetched for a web server of the internet what it redirected to: curl connected to the proxy
// only, which may be anywhere.
TEST(DownloadTest, AProxyOfTheEnvironmentIsNotAsked) {
  std::atomic<int> asked = 0;
  const WebServer proxy([&](std::string_view) {
    ++asked;
    return WebServer::ok("of the proxy");
  });
  const WebServer server([](std::string_view) { return WebServer::ok("of the server"); });
  for (const char* const name : {"http_proxy", "all_proxy"}) {
    setenv(name, proxy.url("").c_str(), 1);
    EXPECT_EQ(download(server.url(), 1000), "of the server") << name;
    unsetenv(name);
  }
  EXPECT_EQ(asked, 0);
}

// Before, the reason was that of a connection that the server had closed after an answer.
TEST(DownloadTest, AConnectionThatIsClosedAfterAnAnswerIsNotTheCause) {
  const WebServer round(
      [](std::string_view) {
        return std::string("HTTP/1.1 302 Found\r\nLocation: /again\r\nContent-Length: 0\r\n\r\n");
      },
      WebServer::Closes::kWhenAskedAgain);
  EXPECT_THAT(faultOf(round.url()), HasSubstr("redirects"));
}

TEST(DownloadTest, CanBeStopped) {
  const WebServer server(
      [](std::string_view) { return std::string("HTTP/1.1 200 OK\r\nContent-Length: 9\r\n\r\nab"); });
  std::stop_source stop;
  stop.request_stop();
  EXPECT_EQ(faultOf(server.url(), 1000, stop.get_token()), "stopped");
}

TEST(DownloadTest, KnowsTheUrlsOfThisMachine) {
  for (const char* const url : {"http://127.0.0.1:8000/", "https://127.9.9.9", "http://localhost/list", "http://[::1]/",
                                "http://user@127.0.0.1/", "http://[::ffff:127.0.0.1]/"})
    EXPECT_TRUE(isOfThisMachine(url)) << url;
  for (const char* const url : {"http://127.0.0.1.example.org/", "http://127.0.0.1@example.org/", "http://[::2]/", "x",
                                "", "http://example.org/#127.0.0.1", "http://localhost.example.org/"})
    EXPECT_FALSE(isOfThisMachine(url)) << url;
}

}  // namespace
}  // namespace platon::download_test
