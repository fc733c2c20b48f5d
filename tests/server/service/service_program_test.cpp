// The program platon-server under a stand-in for systemd.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/net/support/server_fixture.h"
#include "tests/server/service/fake_manager.h"
#include "tests/support/environment_variable.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/wait_until.h"

namespace platon::service_program_test {
namespace {

using Messages = std::vector<std::string>;

class ServiceProgramTest : public ServerTest {
 protected:
  // Waits until the server has told so many messages in all that contain `text`.
  bool hears(const std::string& text, std::ptrdiff_t times = 1) {
    return waitUntil([&] {
      for (const std::string& message : manager_.take()) heard_.push_back(message);
      return count(text) >= times;
    });
  }

  std::ptrdiff_t count(const std::string& text) const {
    return std::count_if(heard_.begin(), heard_.end(),
                         [&](const std::string& message) { return message.find(text) != std::string::npos; });
  }

  const TemporaryFolder folder_ = TemporaryFolder::forSockets();
  const FakeManager manager_{folder_ / "notify"};
  const EnvironmentVariable socket_{"NOTIFY_SOCKET", folder_ / "notify"};
  // So long that the queue of the socket, which holds few messages, is never full of signs of life.
  const EnvironmentVariable period_{"WATCHDOG_USEC", "1000000"};
  Messages heard_;
};

TEST_F(ServiceProgramTest, TheManagerIsToldTheLifeOfTheServer) {
  startServer();
  ASSERT_TRUE(hears("READY=1"));
  EXPECT_EQ(heard_.front(), "READY=1");
  ASSERT_TRUE(hears("WATCHDOG=1", 2));
  server().signal(SIGHUP);
  ASSERT_TRUE(hears("RELOADING=1\nMONOTONIC_USEC="));
  ASSERT_TRUE(hears("READY=1", 2));
  EXPECT_EQ(count("STOPPING=1"), 0);
  stopServer();
  ASSERT_TRUE(hears("STOPPING=1"));
  EXPECT_EQ(heard_.back(), "STOPPING=1");
}

}  // namespace
}  // namespace platon::service_program_test
