#include "protocol/work/worker.h"

#include <atomic>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/protocol/work/held_threads.h"
#include "tests/protocol/work/no_thread.h"
#include "tests/support/wait_until.h"

namespace platon::worker_test {
namespace {

using namespace std::chrono_literals;

void waitForStop(const std::stop_token& stop) {
  EXPECT_TRUE(waitUntil([&] { return stop.stop_requested(); }));
}

TEST(Worker, AResultIsTakenOnce) {
  Worker<std::string> worker;
  worker.add([](const std::stop_token&) { return std::string("done"); });
  EXPECT_TRUE(worker.isPending());
  std::optional<JobResult<std::string>> result;
  EXPECT_TRUE(waitUntil([&] { return (result = worker.poll()).has_value(); }));
  EXPECT_EQ(result->value, "done");
  EXPECT_EQ(result->fault, "");
  EXPECT_FALSE(worker.isPending());
  EXPECT_FALSE(worker.poll());
}

TEST(Worker, NothingIsTakenBeforeTheEnd) {
  std::atomic<bool> goesOn = false;
  Worker<int> worker;
  worker.add([&](const std::stop_token&) { return waitUntil([&] { return goesOn.load(); }) ? 7 : 0; });
  EXPECT_FALSE(worker.poll());
  EXPECT_FALSE(worker.wait(1ms));
  EXPECT_FALSE(worker.finish(1ms));
  EXPECT_FALSE(worker.isIdle());
  EXPECT_TRUE(worker.isPending());
  goesOn = true;
  EXPECT_EQ(worker.wait()->value, 7);
}

TEST(Worker, JobsAreDoneInOrderByOneThreadAtATime) {
  HeldThreads threads;
  threads.hold();
  Worker<int> worker(threads.start());
  std::vector<int> done;
  for (int i = 0; i < 50; ++i) {
    worker.add([&done, i](const std::stop_token&) {
      done.push_back(i);
      return i;
    });
    if (i == 24) threads.letGo();
  }
  EXPECT_TRUE(worker.finish());
  for (int i = 0; i < 50; ++i) {
    EXPECT_EQ(worker.take()->value, i);
    EXPECT_EQ(done[static_cast<std::size_t>(i)], i);
  }
  EXPECT_FALSE(worker.take());
  EXPECT_TRUE(worker.isIdle());
}

TEST(Worker, AResultMayBeMovable) {
  Worker<std::unique_ptr<int>> worker;
  worker.add([](const std::stop_token&) { return std::make_unique<int>(3); });
  EXPECT_EQ(**worker.wait()->value, 3);
}

TEST(Worker, TheEndStopsTheJobAndWaitsForIt) {
  std::atomic<bool> begun = false;
  std::atomic<bool> stopped = false;
  std::atomic<int> others = 0;
  {
    Worker<int> worker;
    worker.add([&](const std::stop_token& stop) {
      begun = true;
      waitForStop(stop);
      stopped = true;
      return 0;
    });
    worker.add([&](const std::stop_token&) { return ++others; });
    EXPECT_TRUE(waitUntil([&] { return begun.load(); }));
  }
  EXPECT_TRUE(stopped);
  EXPECT_EQ(others, 0) << "those that wait are dropped";
}

TEST(Worker, AJobThatDoesNotEndIsNotWaitedForLonger) {
  const auto begun = std::make_shared<std::atomic<bool>>(false);
  const auto goesOn = std::make_shared<std::atomic<bool>>(false);
  const auto ended = std::make_shared<std::atomic<bool>>(false);
  {
    Worker<int> worker(startThread, 1ms);
    worker.add([begun, goesOn, ended](const std::stop_token&) {
      *begun = true;
      waitUntil([&] { return goesOn->load(); });
      *ended = true;
      return 0;
    });
    EXPECT_TRUE(waitUntil([&] { return begun->load(); })) << "a job that waits would be dropped";
    EXPECT_FALSE(worker.finish(1ms));
  }
  EXPECT_FALSE(*ended);
  *goesOn = true;
  EXPECT_TRUE(waitUntil([&] { return ended.use_count() == 1; })) << "the thread ends later";
  EXPECT_TRUE(*ended);
}

TEST(Worker, DroppedJobsAreNotDone) {
  std::atomic<bool> begun = false;
  std::atomic<int> others = 0;
  Worker<int> worker;
  worker.add([&](const std::stop_token& stop) {
    begun = true;
    waitForStop(stop);
    return 1;
  });
  worker.add([&](const std::stop_token&) { return ++others; });
  EXPECT_TRUE(waitUntil([&] { return begun.load(); }));
  worker.drop();
  EXPECT_FALSE(worker.isPending());
  worker.add([](const std::stop_token& stop) { return stop.stop_requested() ? 0 : 2; });
  EXPECT_EQ(worker.wait()->value, 2);
  EXPECT_TRUE(worker.finish());
  EXPECT_FALSE(worker.poll());
  EXPECT_EQ(others, 0);
}

TEST(Worker, WhatAJobThrowsIsTheFault) {
  Worker<int> worker;
  worker.add([](const std::stop_token&) -> int { throw std::runtime_error("the disk is full"); });
  worker.add([](const std::stop_token&) -> int { throw 1; });
  for (const char* const fault : {"the disk is full", "it has failed for an unknown reason"}) {
    const auto result = worker.wait();
    ASSERT_TRUE(result);
    EXPECT_FALSE(result->value);
    EXPECT_EQ(result->fault, fault);
  }
}

TEST(Worker, WithoutAThreadEachPollDoesAJob) {
  std::vector<std::thread::id> workers;
  Worker<int> worker(noThread);
  for (int i = 0; i < 4; ++i) {
    worker.add([&workers, i](const std::stop_token& stop) {
      workers.push_back(std::this_thread::get_id());
      return stop.stop_requested() ? -1 : i;
    });
  }
  EXPECT_TRUE(workers.empty());
  EXPECT_FALSE(worker.isIdle());
  EXPECT_EQ(worker.poll()->value, 0);
  EXPECT_EQ(workers, std::vector{std::this_thread::get_id()});
  EXPECT_FALSE(worker.take());
  EXPECT_EQ(worker.wait()->value, 1);
  EXPECT_TRUE(worker.finish());
  EXPECT_EQ(workers.size(), 4U);
  EXPECT_EQ(worker.take()->value, 2);
  EXPECT_EQ(worker.poll()->value, 3);
}

TEST(Worker, AThreadThatIsThereLaterDoesWhatWaits) {
  bool full = true;
  Worker<std::thread::id> worker(
      [&full](std::function<void()> run) { return full ? noThread(run) : startThread(std::move(run)); });
  const auto self = [](const std::stop_token&) { return std::this_thread::get_id(); };
  worker.add(self);
  full = false;
  worker.add(self);
  for (int i = 0; i < 2; ++i) EXPECT_NE(worker.wait()->value, std::this_thread::get_id());
}

TEST(Worker, AWorkerThatIsMovedGoesOn) {
  Worker<int> worker;
  worker.add([](const std::stop_token&) { return 5; });
  Worker<int> other = std::move(worker);
  EXPECT_EQ(other.wait()->value, 5);
}

TEST(Worker, WithoutAJobThereIsNoResult) {
  Worker<int> worker;
  EXPECT_FALSE(worker.isPending());
  EXPECT_TRUE(worker.isIdle());
  EXPECT_TRUE(worker.finish(0ms));
  EXPECT_FALSE(worker.poll());
  EXPECT_FALSE(worker.wait(1ms));
}

}  // namespace
}  // namespace platon::worker_test
