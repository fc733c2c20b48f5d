#include "client/replay/run_saver.h"

#include <memory>
#include <utility>

namespace platon {

void RunSaver::keep(Run run) {
  waiting_.push_back(std::move(run));
  if (!writing_.isPending()) start();
}

void RunSaver::start() {
  if (waiting_.empty()) return;
  const auto run = std::make_shared<const Run>(std::move(waiting_.front()));
  waiting_.pop_front();
  writing_ = Job<std::string>([store = store_, run](const std::stop_token&) { return RunStore(store).keep(*run); });
}

void RunSaver::take(JobResult<std::string> written) {
  std::string fault = written.value ? std::move(*written.value) : std::move(written.fault);
  if (!fault.empty()) fault_ = std::move(fault);
  start();
}

std::optional<std::string> RunSaver::poll() {
  if (auto written = writing_.poll()) take(std::move(*written));
  return fault_.empty() ? std::nullopt : std::optional(std::exchange(fault_, {}));
}

void RunSaver::finish() {
  while (writing_.isPending()) take(writing_.wait());
}

}  // namespace platon
