#pragma once

#include <gtest/gtest.h>

#include <csignal>
#include <memory>
#include <string>
#include <vector>

#include "tests/support/process.h"

namespace platon {

/// A dedicated server on a free loopback port.
class ServerTest : public testing::Test {
 protected:
  static inline const std::string kLevel = "tests/determinism/golden/levels/hexahedron.level";

  void startServer(std::vector<std::string> options = {}) {
    options.insert(options.begin(), {kLevel, "--bind", "127.0.0.1", "--port", "0"});
    server_ = std::make_unique<Process>(platonCommand("platon-server", options));
    address_ = server_->waitForError("listening on ");
  }

  /// Starts a new server at the same address.
  void restartServer() {
    const std::string port = address_.substr(address_.find(':') + 1);
    server_ =
        std::make_unique<Process>(platonCommand("platon-server", {kLevel, "--bind", "127.0.0.1", "--port", port}));
    server_->waitForError("listening on ");
  }

  /// Stops the server and expects exit code 0.
  void stopServer() {
    server_->signal(SIGTERM);
    EXPECT_EQ(server_->wait(), 0) << server_->errors();
  }

  const std::string& address() const { return address_; }
  Process& server() { return *server_; }

 private:
  std::unique_ptr<Process> server_;
  std::string address_;
};

}  // namespace platon
