#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <vector>

#include "client/replay/facts_reader.h"
#include "client/replay/listed_run.h"
#include "client/replay/run_store.h"

namespace platon {

/// The recordings that the player can look at: the runs of a store, newest first, then those in the folder of ghosts,
/// newest first, then those that lie elsewhere. At first only what the names and dates of the files tell is known; a
/// thread reads the rest.
class RunList {
 public:
  /// Most runs of the player, and most recordings of others, that are listed: the newest.
  static constexpr std::size_t kMaxOwn = 2048;
  static constexpr std::size_t kMaxOthers = 64;

  /// An empty path: there are no ghosts.
  RunList(RunStore own, std::filesystem::path ghosts, ThreadStart start = &startThread);

  /// Looks at the folders anew. Does not wait until the recordings have been read.
  void load();
  /// Takes what has been read. Returns whether anything has.
  bool poll();
  /// Adds a recording that lies elsewhere, unless it is there. Returns its index.
  std::size_t indexOf(const std::filesystem::path& file);

  std::span<const ListedRun> runs() const { return runs_; }
  /// Number of the recordings that do not lie elsewhere; they come first.
  std::size_t listed() const { return listed_; }

 private:
  void add(const DatedFile& file, ListedRun run);
  void fill();
  void markBest();

  RunStore own_;
  std::filesystem::path ghosts_;
  FactsReader reader_;
  std::vector<DatedFile> files_;  // of runs_
  std::vector<ListedRun> runs_;
  std::size_t listed_ = 0;
};

}  // namespace platon
