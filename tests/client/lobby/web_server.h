#pragma once

#include <gtest/gtest.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <functional>
#include <string>
#include <string_view>
#include <thread>

#include "protocol/files/descriptor.h"

namespace platon {

/// A web server on loopback that answers each request with what `answer` makes of its first line, byte by byte as it
/// is.
class WebServer {
 public:
  using Answer = std::function<std::string(std::string_view request)>;
  /// When the server closes a connection.
  enum class Closes {
    kAfterAnAnswer,
    kWhenAskedAgain  ///< without an answer, or when the client has closed it
  };

  explicit WebServer(Answer answer, Closes closes = Closes::kAfterAnAnswer)
      : closes_(closes), listener_(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    EXPECT_EQ(bind(listener_.number(), reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
    EXPECT_EQ(listen(listener_.number(), 8), 0);
    socklen_t size = sizeof address;
    getsockname(listener_.number(), reinterpret_cast<sockaddr*>(&address), &size);
    port_ = ntohs(address.sin_port);
    thread_ = std::jthread([this, answer = std::move(answer)](const std::stop_token& stop) { serve(answer, stop); });
  }

  std::string url(const std::string& path = "/") const { return "http://127.0.0.1:" + std::to_string(port_) + path; }

  /// An answer with this content.
  static std::string ok(const std::string& content) {
    return "HTTP/1.1 200 OK\r\nContent-Length: " + std::to_string(content.size()) + "\r\n\r\n" + content;
  }

 private:
  void serve(const Answer& answer, const std::stop_token& stop) const {
    while (!stop.stop_requested()) {
      pollfd ready{listener_.number(), POLLIN, 0};
      if (poll(&ready, 1, 20) <= 0) continue;
      const Descriptor client(accept(listener_.number(), nullptr, nullptr));
      std::array<char, 4096> request{};
      const ssize_t size = recv(client.number(), request.data(), request.size(), 0);
      if (size <= 0) continue;
      const std::string_view text(request.data(), static_cast<std::size_t>(size));
      const std::string reply = answer(text.substr(0, text.find("\r\n")));
      send(client.number(), reply.data(), reply.size(), MSG_NOSIGNAL);
      if (closes_ == Closes::kWhenAskedAgain) waitForMore(client, stop);
    }
  }

  // Waits until the client has sent more or has closed the connection.
  static void waitForMore(const Descriptor& client, const std::stop_token& stop) {
    pollfd ready{client.number(), POLLIN, 0};
    while (!stop.stop_requested() && poll(&ready, 1, 20) <= 0) continue;
  }

  Closes closes_;
  Descriptor listener_;
  int port_ = 0;
  std::jthread thread_;
};

}  // namespace platon
