#pragma once

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>

#include <cstddef>
#include <string>
#include <vector>

#include "protocol/files/descriptor.h"

namespace platon {

/// Receives what services tell, as systemd does.
class FakeManager {
 public:
  /// `name`: a path, or '@' and an abstract name.
  explicit FakeManager(const std::string& name) : socket_(::socket(AF_UNIX, SOCK_DGRAM | SOCK_NONBLOCK, 0)) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    name.copy(address.sun_path, name.size());
    if (name.front() == '@') address.sun_path[0] = '\0';
    const auto length = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + name.size());
    EXPECT_EQ(bind(socket_.number(), reinterpret_cast<const sockaddr*>(&address), length), 0);
  }

  /// The messages since the last call.
  std::vector<std::string> take() const {
    std::vector<std::string> messages;
    std::string buffer(256, '\0');
    while (true) {
      const ssize_t size = recv(socket_.number(), buffer.data(), buffer.size(), 0);
      if (size < 0) return messages;
      messages.push_back(buffer.substr(0, static_cast<std::size_t>(size)));
    }
  }

 private:
  Descriptor socket_;
};

}  // namespace platon
