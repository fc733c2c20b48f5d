#include "client/replay/run_saver.h"

#include <chrono>
#include <utility>

namespace platon {

void RunSaver::keep(Run run) {
  waiting_.push_back(std::move(run));
  if (!writing_.valid()) start();
}

void RunSaver::start() {
  if (waiting_.empty()) return;
  writing_ = std::async(std::launch::async,
                        [store = store_, run = std::move(waiting_.front())]() mutable { return store.keep(run); });
  waiting_.pop_front();
}

void RunSaver::take() {
  if (std::string fault = writing_.get(); !fault.empty()) fault_ = std::move(fault);
  start();
}

std::optional<std::string> RunSaver::poll() {
  if (writing_.valid() && writing_.wait_for(std::chrono::seconds(0)) == std::future_status::ready) take();
  return fault_.empty() ? std::nullopt : std::optional(std::exchange(fault_, {}));
}

void RunSaver::finish() {
  while (writing_.valid()) take();
}

}  // namespace platon
