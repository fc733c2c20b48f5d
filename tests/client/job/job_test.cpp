#include "client/job/job.h"

#include <atomic>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>

#include <gtest/gtest.h>

#include "tests/client/job/no_thread.h"
#include "tests/support/wait_until.h"

namespace platon::job_test {
namespace {

void waitForStop(const std::stop_token& stop) {
  EXPECT_TRUE(waitUntil([&] { return stop.stop_requested(); }));
}

TEST(Job, TheResultIsTakenOnce) {
  Job<std::string> job([](const std::stop_token&) { return std::string("done"); });
  EXPECT_TRUE(job.isPending());
  std::optional<JobResult<std::string>> result;
  EXPECT_TRUE(waitUntil([&] { return (result = job.poll()).has_value(); }));
  EXPECT_EQ(result->value, "done");
  EXPECT_EQ(result->fault, "");
  EXPECT_FALSE(job.isPending());
  EXPECT_FALSE(job.poll());
}

TEST(Job, NothingIsTakenBeforeTheEnd) {
  std::atomic<bool> goesOn = false;
  Job<int> job([&](const std::stop_token&) { return waitUntil([&] { return goesOn.load(); }) ? 7 : 0; });
  EXPECT_FALSE(job.poll());
  EXPECT_TRUE(job.isPending());
  goesOn = true;
  EXPECT_EQ(job.wait().value, 7);
}

TEST(Job, TheResultMayBeMovable) {
  Job<std::unique_ptr<int>> job([](const std::stop_token&) { return std::make_unique<int>(3); });
  EXPECT_EQ(**job.wait().value, 3);
}

TEST(Job, TheEndStopsTheWorkAndWaitsForIt) {
  std::atomic<bool> stopped = false;
  {
    const Job<int> job([&](const std::stop_token& stop) {
      waitForStop(stop);
      stopped = true;
      return 0;
    });
  }
  EXPECT_TRUE(stopped);
}

TEST(Job, AnotherJobStopsTheOneBefore) {
  Job<int> job([](const std::stop_token& stop) {
    waitForStop(stop);
    return 1;
  });
  job = Job<int>([](const std::stop_token&) { return 2; });
  EXPECT_EQ(job.wait().value, 2);
}

TEST(Job, WhatTheWorkThrowsIsTheFault) {
  Job<int> job([](const std::stop_token&) -> int { throw std::runtime_error("the disk is full"); });
  const JobResult<int> result = job.wait();
  EXPECT_FALSE(result.value);
  EXPECT_EQ(result.fault, "the disk is full");
}

TEST(Job, WithoutAThreadTheWorkIsDoneAtOnce) {
  std::thread::id worker;
  Job<int> job(
      [&](const std::stop_token& stop) {
        worker = std::this_thread::get_id();
        return stop.stop_requested() ? 0 : 5;
      },
      noThread);
  EXPECT_EQ(worker, std::this_thread::get_id());
  EXPECT_EQ(job.poll()->value, 5);
}

TEST(Job, NoJobIsNotPending) {
  Job<int> job;
  EXPECT_FALSE(job.isPending());
  EXPECT_FALSE(job.poll());
}

}  // namespace
}  // namespace platon::job_test
