#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <string>

#include "client/job/job.h"
#include "client/replay/run_store.h"

namespace platon {

/// Keeps runs in a store without waiting for the disk: a thread writes them, one after the other.
class RunSaver {
 public:
  explicit RunSaver(RunStore store, ThreadStart start = &startThread)
      : store_(std::move(store)), start_(std::move(start)) {}
  /// Waits until all runs are kept.
  ~RunSaver() { finish(); }
  RunSaver(const RunSaver&) = delete;
  RunSaver& operator=(const RunSaver&) = delete;

  void keep(Run run);
  /// Goes on with the next run. Call now and then. Returns why the last one could not be kept, once.
  std::optional<std::string> poll();
  /// Waits until all runs are kept, or have failed.
  void finish();

  /// Whether runs are still being written.
  bool isPending() const { return writing_.isPending(); }
  /// The last run on this level that is not written yet; null if there is none.
  std::shared_ptr<const Run> unsavedOn(const Level& level) const;

  /// Holds all runs only after `finish`.
  const RunStore& store() const { return store_; }

 private:
  void startNext();
  void take(JobResult<std::string> written);

  RunStore store_;
  ThreadStart start_;
  std::deque<std::shared_ptr<const Run>> waiting_;  // while a thread writes, the first one is being written
  Job<std::string> writing_;                        // why it failed, or an empty text
  std::string fault_;                               // not reported yet
};

}  // namespace platon
