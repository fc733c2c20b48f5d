#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "client/replay/run_store.h"
#include "platon/game/level.h"
#include "protocol/files/bounded_folder.h"
#include "protocol/work/worker.h"

namespace platon {

/// What a list tells of a recording.
struct RecordingFacts {
  std::uint32_t rules = 0;               ///< version of the rules it was made by; 0: unknown
  std::shared_ptr<const Level> level{};  ///< null if it cannot be read
  std::optional<std::uint32_t> ticks{};  ///< the time of the run; nothing: it is none, or it cannot be played
  std::string note{};                    ///< why it cannot be played, as the end of a sentence; empty: as far as known,
                                         ///< it can
  std::string noRun{};                   ///< why it shows no run, likewise; empty: it does, or cannot be played
};

/// Reads all blocks of a recording, but plays only the last one with ticks: that gives the time of a run. So a
/// recording may still be refused when it is played whole. Ends early with the present MiB, block or tick when it is
/// asked to stop; then the facts are not to be used.
RecordingFacts readRecordingFacts(const std::filesystem::path& file, const std::stop_token& stop = {});

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

/// A recording as a list shows it.
struct ListedRun {
  std::filesystem::path file;
  std::shared_ptr<const Level> level{};  ///< null if it is not known
  std::optional<std::uint32_t> ticks{};  ///< its time; nothing: it is no run, or the time is not known
  std::string date{};                    ///< in UTC, `2026-12-01`; empty: unknown
  std::string note{};                    ///< why it cannot be played; empty: it can, as far as is known
  std::string noRun{};                   ///< why it shows no run; empty: it does, or that is not known
  std::string who{};                     ///< whose it is; empty: the player's own
  bool isBest = false;                   ///< the shortest one of own games on a level by the present rules
  bool isRead = false;                   ///< nothing more becomes known
};

/// The date of a file as ListedRun shows it.
std::string dateText(std::filesystem::file_time_type date);

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
