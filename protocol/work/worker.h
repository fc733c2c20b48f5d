#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <utility>

namespace platon {

/// What a job has led to.
template <class Result>
struct JobResult {
  std::optional<Result> value;  ///< nothing: the job has failed
  std::string fault;            ///< why it has failed, a sentence; empty: it has not
};

/// Starts a thread that runs this, or throws std::system_error if there can be none.
using ThreadStart = std::function<std::thread(std::function<void()> run)>;

/// The usual way. The thread blocks all signals, so they reach the main thread only.
std::thread startThread(std::function<void()> run);

/// Runs jobs one after the other in a thread that lives as long as there are any. Where no thread can be started, they
/// run when `step` or `finish` is called. The part of a Worker that does not depend on what its jobs result in.
class JobThread {
 public:
  using Job = std::function<void(const std::stop_token& stop)>;

  JobThread(ThreadStart start, std::chrono::milliseconds endTime);
  ~JobThread();
  JobThread(const JobThread&) = delete;
  JobThread& operator=(const JobThread&) = delete;

  void add(Job job);
  void drop();
  /// Runs the next job, if there is no thread for it.
  void step();
  bool finish(std::chrono::milliseconds limit);
  /// Whether nothing runs, and nothing waits to run.
  bool isIdle() const;

 private:
  struct Shared;

  static void run(Shared& shared);

  ThreadStart start_;
  std::chrono::milliseconds endTime_;
  std::shared_ptr<Shared> shared_;  // with the thread, which outlives this if a job does not end in time
  std::thread thread_;
};

/// Does jobs in a thread, one after the other. Their results are polled, in the same order. Where there are no threads,
/// `poll` does one job in each call.
///
/// A job owns all that it uses, since it may outlive the worker.
template <class Result>
class Worker {
 public:
  /// Returns early, with any result, once it is asked to stop: then nobody takes it. What it throws is a fault.
  using Work = std::function<Result(const std::stop_token& stop)>;

  /// How long the destructor usually waits.
  static constexpr std::chrono::seconds kEndTime{10};

  explicit Worker(ThreadStart start = &startThread, std::chrono::milliseconds endTime = kEndTime)
      : jobs_(std::make_unique<JobThread>(std::move(start), endTime)) {}
  /// One that was moved away may only be destroyed.
  Worker(Worker&&) noexcept = default;
  Worker& operator=(Worker&&) = delete;
  /// Drops the jobs, and waits for the present one for at most `endTime`.
  ~Worker() = default;

  void add(Work work);
  /// Asks the present job to stop, and forgets it, those that wait and the results. Does not wait.
  void drop();
  /// Drops the jobs before this one.
  void restart(Work work) { drop(), add(std::move(work)); }

  /// Jobs whose results have not been taken.
  std::size_t pending() const { return pending_; }
  bool isPending() const { return pending_ > 0; }
  /// Whether no job is being done or waits, dropped ones included.
  bool isIdle() const { return jobs_->isIdle(); }

  /// Takes the next result; nothing if there is none yet.
  std::optional<JobResult<Result>> poll();
  /// As poll, but does no job itself: for all but the first of the results that are taken at a time.
  std::optional<JobResult<Result>> take();
  /// As poll, but waits for a result for at most `limit`, also if there is no job.
  std::optional<JobResult<Result>> wait(std::chrono::milliseconds limit = kEndTime);
  /// Waits until all jobs are done, for at most `limit`. Returns whether they are.
  bool finish(std::chrono::milliseconds limit = kEndTime) { return jobs_->finish(limit); }

 private:
  // Of the jobs since the last drop.
  struct Results {
    std::mutex mutex;
    std::condition_variable added;
    std::deque<JobResult<Result>> ready;
  };

  static JobResult<Result> resultOf(const Work& work, const std::stop_token& stop);

  std::shared_ptr<Results> results_ = std::make_shared<Results>();
  std::size_t pending_ = 0;
  std::unique_ptr<JobThread> jobs_;
};

template <class Result>
void Worker<Result>::add(Work work) {
  ++pending_;
  jobs_->add([results = results_, work = std::move(work)](const std::stop_token& stop) {
    JobResult<Result> result = resultOf(work, stop);
    const std::lock_guard lock(results->mutex);
    results->ready.push_back(std::move(result));
    results->added.notify_one();
  });
}

template <class Result>
void Worker<Result>::drop() {
  jobs_->drop();
  results_ = std::make_shared<Results>();
  pending_ = 0;
}

template <class Result>
std::optional<JobResult<Result>> Worker<Result>::poll() {
  jobs_->step();
  return take();
}

template <class Result>
std::optional<JobResult<Result>> Worker<Result>::take() {
  const std::lock_guard lock(results_->mutex);
  if (results_->ready.empty()) return std::nullopt;
  JobResult<Result> result = std::move(results_->ready.front());
  results_->ready.pop_front();
  --pending_;
  return result;
}

template <class Result>
std::optional<JobResult<Result>> Worker<Result>::wait(std::chrono::milliseconds limit) {
  jobs_->step();
  {
    std::unique_lock lock(results_->mutex);
    results_->added.wait_for(lock, limit, [this] { return !results_->ready.empty(); });
  }
  return take();
}

template <class Result>
JobResult<Result> Worker<Result>::resultOf(const Work& work, const std::stop_token& stop) {
  try {
    return {work(stop), {}};
  } catch (const std::exception& fault) {
    return {std::nullopt, fault.what()};
  } catch (...) {
    return {std::nullopt, "it has failed for an unknown reason"};
  }
}

}  // namespace platon
