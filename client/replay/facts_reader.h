#pragma once

#include <cstddef>
#include <deque>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "client/job/job.h"
#include "client/replay/recording_facts.h"
#include "protocol/files/bounded_folder.h"

namespace platon {

/// Reads the facts of recordings in a thread, one after the other; without a thread, one in each call of `poll`.
/// Remembers those of the files that it was last asked for, as long as a file has the same size and date.
class FactsReader {
 public:
  explicit FactsReader(ThreadStart start = &startThread) : start_(std::move(start)) {}

  /// Reads the facts of these files that are not known, and stops reading and forgets those of others. Does not wait.
  void read(const std::vector<DatedFile>& files);
  /// Takes what has been read. Returns whether anything has.
  bool poll();
  /// The facts of a file as soon as they have been taken; null until then.
  const RecordingFacts* find(const std::filesystem::path& file) const;

 private:
  struct Known {
    DatedFile file;
    RecordingFacts facts;
  };
  // Between the threads.
  struct Found {
    std::mutex mutex;
    std::vector<Known> facts;
  };

  static Known readOne(const DatedFile& file, const std::stop_token& stop);
  // Returns false, and reads nothing, if there are several files and no thread.
  static bool readAll(const std::vector<DatedFile>& files, Found& found, const std::stop_token& stop);
  void start(std::vector<DatedFile> files);
  std::optional<JobResult<bool>> pollJob();
  bool knows(const DatedFile& file) const;
  void remember(Known known);

  ThreadStart start_;
  std::map<std::filesystem::path, Known> known_;
  std::vector<DatedFile> reading_;  // what the job reads
  std::deque<DatedFile> waiting_;   // for a job of their own each, because there is no thread
  std::shared_ptr<Found> found_ = std::make_shared<Found>();
  Job<bool> job_;
};

}  // namespace platon
