#pragma once

#include <cstddef>
#include <deque>
#include <filesystem>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "client/replay/recording_facts.h"
#include "protocol/files/bounded_folder.h"
#include "protocol/work/worker.h"

namespace platon {

/// Reads the facts of recordings in a thread, one after the other; without a thread, one in each call of `poll`.
/// Remembers those of the files that it was last asked for, as long as a file has the same size and date.
class FactsReader {
 public:
  explicit FactsReader(ThreadStart start = &startThread) : reading_(std::move(start)) {}

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

  static RecordingFacts read(const DatedFile& file, const std::stop_token& stop);
  bool knows(const DatedFile& file) const;
  void remember(Known known);

  std::map<std::filesystem::path, Known> known_;
  std::deque<DatedFile> files_;  // that are being read
  Worker<RecordingFacts> reading_;
};

}  // namespace platon
