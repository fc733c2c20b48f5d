#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <string>

#include "client/replay/run_store.h"
#include "protocol/work/worker.h"

namespace platon {

/// Keeps runs in a store without waiting for the disk: a thread writes them, one after the other.
class RunSaver {
 public:
  explicit RunSaver(RunStore store, ThreadStart start = &startThread)
      : store_(std::move(store)), writing_(std::move(start)) {}
  /// Waits as `finish` does.
  ~RunSaver() { finish(); }
  RunSaver(const RunSaver&) = delete;
  RunSaver& operator=(const RunSaver&) = delete;

  void keep(Run run);
  /// Call now and then. Returns why the last one could not be kept, once.
  std::optional<std::string> poll();
  /// Waits until all runs are kept, or have failed, for at most Worker::kEndTime.
  void finish();

  /// Whether runs are still being written.
  bool isPending() const { return writing_.isPending(); }
  /// The last run on this level that is not written yet; null if there is none.
  std::shared_ptr<const Run> unsavedOn(const Level& level) const;

  /// Holds all runs only after `finish`.
  const RunStore& store() const { return store_; }

 private:
  void takeWritten();

  RunStore store_;
  std::deque<std::shared_ptr<const Run>> waiting_;  // also the one that is being written
  std::string fault_;                               // not reported yet
  Worker<std::string> writing_;                     // why it failed, or an empty text
};

}  // namespace platon
