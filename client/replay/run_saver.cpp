#include "client/replay/run_saver.h"

#include <algorithm>
#include <utility>

#include "client/replay/same_level.h"

namespace platon {

void RunSaver::keep(Run run) {
  waiting_.push_back(std::make_shared<const Run>(std::move(run)));
  writing_.add(
      [store = store_, kept = waiting_.back()](const std::stop_token&) { return RunStore(store).keep(*kept); });
}

void RunSaver::takeWritten() {
  for (auto written = writing_.poll(); written; written = writing_.take()) {
    std::string fault = written->value ? std::move(*written->value) : std::move(written->fault);
    if (!fault.empty()) fault_ = std::move(fault);
    waiting_.pop_front();
  }
}

std::shared_ptr<const Run> RunSaver::unsavedOn(const Level& level) const {
  const auto last = std::find_if(waiting_.rbegin(), waiting_.rend(),
                                 [&](const auto& run) { return isSameLevel(*run->level, level); });
  return last == waiting_.rend() ? nullptr : *last;
}

std::optional<std::string> RunSaver::poll() {
  takeWritten();
  return fault_.empty() ? std::nullopt : std::optional(std::exchange(fault_, {}));
}

void RunSaver::finish() {
  writing_.finish();
  takeWritten();
}

}  // namespace platon
