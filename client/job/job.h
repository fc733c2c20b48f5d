#pragma once

#include <atomic>
#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <system_error>
#include <thread>
#include <utility>

namespace platon {

/// What a job has led to.
template <class Result>
struct JobResult {
  std::optional<Result> value;  ///< nothing: the job has failed
  std::string fault;            ///< what the job has thrown, a sentence; empty: nothing
};

/// Starts a thread, or throws std::system_error if there is none.
using ThreadStart = std::function<std::jthread(std::function<void(const std::stop_token&)>)>;

/// The usual way.
inline std::jthread startThread(std::function<void(const std::stop_token&)> work) {
  return std::jthread(std::move(work));
}

/// Work in a thread of its own, whose result is polled. Without a thread the work is done at once, by the caller: then
/// it cannot be asked to stop, as `stop_possible` of its token tells.
template <class Result>
class Job {
 public:
  /// Returns early, with any result, once it is asked to stop: then nobody takes it.
  using Work = std::function<Result(const std::stop_token&)>;

  /// No job.
  Job() = default;
  explicit Job(Work work, const ThreadStart& start = &startThread);
  Job(Job&&) noexcept = default;
  /// Ends the job before, as the destructor does.
  Job& operator=(Job&&) noexcept = default;
  /// Asks the work to stop, and waits until it has.
  ~Job() = default;

  /// Whether there is a job whose result has not been taken.
  bool isPending() const { return state_ != nullptr; }
  /// Takes the result as soon as the work is done; nothing until then.
  std::optional<JobResult<Result>> poll() { return state_ && state_->isDone ? std::optional(wait()) : std::nullopt; }
  /// Waits until the work is done, and takes the result. There is a job.
  JobResult<Result> wait();

 private:
  struct State {
    JobResult<Result> result;
    std::atomic<bool> isDone = false;  // then the thread writes nothing more
  };

  static JobResult<Result> resultOf(const Work& work, const std::stop_token& stop);

  std::shared_ptr<State> state_;  // null: no job
  std::jthread thread_;
};

template <class Result>
Job<Result>::Job(Work work, const ThreadStart& start) : state_(std::make_shared<State>()) {
  const auto run = [state = state_, work = std::move(work)](const std::stop_token& stop) {
    state->result = resultOf(work, stop);
    state->isDone = true;
  };
  try {
    thread_ = start(run);
  } catch (const std::system_error&) {
    run(std::stop_token());
  }
}

template <class Result>
JobResult<Result> Job<Result>::wait() {
  if (thread_.joinable()) thread_.join();
  return std::move(std::exchange(state_, nullptr)->result);
}

template <class Result>
JobResult<Result> Job<Result>::resultOf(const Work& work, const std::stop_token& stop) {
  try {
    return {work(stop), {}};
  } catch (const std::exception& fault) {
    return {std::nullopt, fault.what()};
  }
}

}  // namespace platon
