#include "protocol/work/worker.h"

#include <system_error>

#include "protocol/work/blocked_signals.h"

namespace platon {

struct JobThread::Shared {
  std::mutex mutex;
  std::condition_variable ended;
  std::deque<Job> queue;   // this and all below: under the mutex
  std::stop_source stop;   // of the jobs since the last drop
  bool hasThread = false;  // a thread runs the jobs, or is about to

  // Runs the first of the queue.
  void runNext(std::unique_lock<std::mutex>& lock) {
    Job job = std::move(queue.front());
    queue.pop_front();
    const std::stop_token token = stop.get_token();
    lock.unlock();
    job(token);
    job = nullptr;
    lock.lock();
  }

  void drop() {
    queue.clear();
    stop.request_stop();
    stop = std::stop_source();
  }
};

std::thread startThread(std::function<void()> run) {
  const BlockedSignals blocked;
  return std::thread(std::move(run));
}

JobThread::JobThread(ThreadStart start, std::chrono::milliseconds endTime)
    : start_(std::move(start)), endTime_(endTime), shared_(std::make_shared<Shared>()) {}

JobThread::~JobThread() {
  std::unique_lock lock(shared_->mutex);
  shared_->drop();
  const bool ended = shared_->ended.wait_for(lock, endTime_, [this] { return !shared_->hasThread; });
  lock.unlock();
  if (thread_.joinable()) ended ? thread_.join() : thread_.detach();
}

// A thread that has run all its jobs before is at its end.
void JobThread::add(Job job) {
  {
    const std::lock_guard lock(shared_->mutex);
    shared_->queue.push_back(std::move(job));
    if (std::exchange(shared_->hasThread, true)) return;
  }
  if (thread_.joinable()) thread_.join();
  try {
    thread_ = start_([shared = shared_] { run(*shared); });
  } catch (const std::system_error&) {
    const std::lock_guard lock(shared_->mutex);
    shared_->hasThread = false;
  }
}

void JobThread::run(Shared& shared) {
  std::unique_lock lock(shared.mutex);
  while (!shared.queue.empty()) shared.runNext(lock);
  shared.hasThread = false;
  shared.ended.notify_all();
}

void JobThread::drop() {
  const std::lock_guard lock(shared_->mutex);
  shared_->drop();
}

void JobThread::step() {
  std::unique_lock lock(shared_->mutex);
  if (!shared_->hasThread && !shared_->queue.empty()) shared_->runNext(lock);
}

bool JobThread::finish(std::chrono::milliseconds limit) {
  std::unique_lock lock(shared_->mutex);
  if (!shared_->ended.wait_for(lock, limit, [this] { return !shared_->hasThread; })) return false;
  while (!shared_->queue.empty()) shared_->runNext(lock);
  return true;
}

bool JobThread::isIdle() const {
  const std::lock_guard lock(shared_->mutex);
  return !shared_->hasThread && shared_->queue.empty();
}

}  // namespace platon
