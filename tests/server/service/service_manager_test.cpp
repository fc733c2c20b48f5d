#include "server/service/service_manager.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "tests/server/service/fake_manager.h"
#include "tests/support/temporary_folder.h"

namespace platon::service_manager_test {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

using Messages = std::vector<std::string>;

class ServiceManagerTest : public testing::Test {
 protected:
  ServiceManager::Environment environment(const char* microseconds = nullptr, const char* process = nullptr) const {
    return {path_.c_str(), microseconds, process, 42};
  }

  const TemporaryFolder folder_ = TemporaryFolder::forSockets();
  const std::string path_ = folder_ / "notify";
  const FakeManager manager_{path_};
  const TimePoint start_ = TimePoint(seconds(100));
};

TEST_F(ServiceManagerTest, TellsEachState) {
  ServiceManager manager(environment());
  manager.ready();
  manager.reloading(start_ + std::chrono::nanoseconds(1'500));
  manager.ready();
  manager.stopping();
  EXPECT_EQ(manager_.take(), (Messages{"READY=1", "RELOADING=1\nMONOTONIC_USEC=100000001", "READY=1", "STOPPING=1"}));
}

TEST_F(ServiceManagerTest, AnAbstractSocketIsReached) {
  const std::string name = "@platon-test-" + std::to_string(getpid());
  const FakeManager abstract(name);
  ServiceManager({name.c_str()}).ready();
  EXPECT_EQ(abstract.take(), Messages{"READY=1"});
}

TEST_F(ServiceManagerTest, ASignOfLifeIsGivenTwiceInAPeriod) {
  ServiceManager manager(environment("10000000", "42"));
  EXPECT_TRUE(manager.watched());
  for (TimePoint now = start_; now < start_ + seconds(20); now += milliseconds(250)) manager.alive(now, false);
  EXPECT_EQ(manager_.take(), Messages(4, "WATCHDOG=1"));
}

TEST_F(ServiceManagerTest, ADrainAsksForMoreTime) {
  ServiceManager manager(environment("10000000"));
  manager.alive(start_, true);
  EXPECT_EQ(manager_.take(), Messages{"WATCHDOG=1\nEXTEND_TIMEOUT_USEC=60000000"});
}

TEST_F(ServiceManagerTest, ALoopThatStandsStillGivesNoSign) {
  ServiceManager manager(environment("10000000"));
  manager.alive(start_, false);
  manager.alive(start_ + milliseconds(4'999), false);
  EXPECT_EQ(manager_.take(), Messages{"WATCHDOG=1"});
  manager.alive(start_ + seconds(3600), false);
  manager.alive(start_ + seconds(3600), false);
  EXPECT_EQ(manager_.take(), Messages{"WATCHDOG=1"});
}

TEST_F(ServiceManagerTest, NoWatchdogWaitsWithoutAPeriodOrForAnotherProcess) {
  for (const auto& other : {environment(), environment("0"), environment("ten"), environment("-5"), environment(""),
                            environment("10000000", "41"), environment("10000000", "")}) {
    ServiceManager manager(other);
    EXPECT_FALSE(manager.watched());
    manager.alive(start_, false);
  }
  EXPECT_EQ(manager_.take(), Messages{});
}

TEST_F(ServiceManagerTest, WhoListensNoMoreHoldsNothingUp) {
  const std::string longest(200, 'x');
  const std::vector<std::string> sockets{"", "/", "@", "notify", "/" + longest, folder_ / "nobody"};
  for (const std::string& socket : sockets) {
    ServiceManager manager({socket.c_str(), "10000000"});
    manager.ready();
    manager.alive(start_, false);
    manager.stopping();
  }
  ServiceManager nobody({nullptr, "10000000"});
  nobody.ready();
  EXPECT_FALSE(nobody.watched());
}

TEST_F(ServiceManagerTest, AFullQueueHoldsNothingUp) {
  ServiceManager manager(environment());
  for (int i = 0; i < 10'000; ++i) manager.ready();
  EXPECT_FALSE(manager_.take().empty());
}

TEST_F(ServiceManagerTest, TheEnvironmentNamesTheSocket) {
  ASSERT_EQ(setenv("NOTIFY_SOCKET", path_.c_str(), 1), 0);
  const ServiceManager::Environment current = ServiceManager::Environment::current();
  EXPECT_EQ(current.socket, path_);
  EXPECT_EQ(current.process, getpid());
  ASSERT_EQ(unsetenv("NOTIFY_SOCKET"), 0);
  EXPECT_EQ(ServiceManager::Environment::current().socket, nullptr);
}

}  // namespace
}  // namespace platon::service_manager_test
