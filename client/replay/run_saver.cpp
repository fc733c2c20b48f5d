#include "client/replay/run_saver.h"

#include <algorithm>
#include <utility>

#include "client/replay/same_level.h"

namespace platon {

void RunSaver::keep(Run run) {
  waiting_.push_back(std::make_shared<const Run>(std::move(run)));
  if (!writing_.isPending()) startNext();
}

void RunSaver::startNext() {
  if (waiting_.empty()) return;
  writing_ = Job<std::string>(
      [store = store_, run = waiting_.front()](const std::stop_token&) { return RunStore(store).keep(*run); }, start_);
}

void RunSaver::take(JobResult<std::string> written) {
  std::string fault = written.value ? std::move(*written.value) : std::move(written.fault);
  if (!fault.empty()) fault_ = std::move(fault);
  waiting_.pop_front();
  startNext();
}

std::shared_ptr<const Run> RunSaver::unsavedOn(const Level& level) const {
  const auto last = std::find_if(waiting_.rbegin(), waiting_.rend(),
                                 [&](const auto& run) { return isSameLevel(*run->level, level); });
  return last == waiting_.rend() ? nullptr : *last;
}

std::optional<std::string> RunSaver::poll() {
  if (auto written = writing_.poll()) take(std::move(*written));
  return fault_.empty() ? std::nullopt : std::optional(std::exchange(fault_, {}));
}

void RunSaver::finish() {
  while (writing_.isPending()) take(writing_.wait());
}

}  // namespace platon
