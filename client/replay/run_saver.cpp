#include "client/replay/run_saver.h"

#include <chrono>
#include <memory>
#include <system_error>
#include <utility>

namespace platon {

void RunSaver::keep(Run run) {
  waiting_.push_back(std::move(run));
  if (!writing_.valid()) start();
}

void RunSaver::start() {
  if (waiting_.empty()) return;
  const auto run = std::make_shared<const Run>(std::move(waiting_.front()));
  waiting_.pop_front();
  try {
    writing_ = std::async(std::launch::async, [store = store_, run]() mutable { return store.keep(*run); });
  } catch (const std::system_error&) {  // no thread
    fault_ = store_.keep(*run);
  }
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
