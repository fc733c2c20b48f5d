#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "client/replay/replay.h"
#include "client/replay/run_cutter.h"
#include "protocol/work/worker.h"

namespace platon {

/// A best run that is kept.
struct StoredRun {
  std::filesystem::path file;
  std::uint64_t level = 0;               ///< hash of the level
  std::uint32_t rules = 0;               ///< version of the rules it was played by
  std::uint32_t ticks = 0;               ///< its time
  std::uint64_t bytes = 0;               ///< of the file, when it was found in the folder
  std::filesystem::file_time_type date;  ///< when the file was written
};

/// Whether a file has a name that a RunStore gives to runs.
bool hasNameOfRun(const std::filesystem::path& file);

/// The best run on each level by each version of the rules: a folder with one recording each, whose name is the hash of
/// the level, the version of the rules and the ticks. A file that is copied here counts like the others. A folder that
/// cannot be read or written keeps nothing.
///
/// Runs on other servers are in a folder for each server, `servers/NAME`, with bounds of their own: a server decides
/// which inputs count, so its runs neither push out nor replace those of the player's own games, nor those on others.
class RunStore {
 public:
  /// Bounds of the runs of own games; the runs that were written longest ago are removed.
  static constexpr std::size_t kMaxRuns = 512;
  static constexpr std::uint64_t kMaxBytes = std::uint64_t{64} << 20;
  /// Bounds of the folder of each server.
  static constexpr std::size_t kMaxServerRuns = 64;
  static constexpr std::uint64_t kMaxServerBytes = std::uint64_t{16} << 20;
  /// Most folders of servers; those in which a run was kept longest ago are removed.
  static constexpr std::size_t kMaxServers = 16;
  /// Most bytes of a run that is kept.
  static constexpr std::size_t kMaxRunBytes = std::size_t{4} << 20;

  /// Name of the file of a run by the present rules on a level with this hash.
  static std::string fileNameOf(std::uint64_t level, std::uint32_t ticks);

  /// An empty path: nothing is kept. `server`: name of a folder for the server on which runs are played; empty: it is
  /// the player's own.
  explicit RunStore(std::filesystem::path folder, std::string server = {})
      : folder_(std::move(folder)), server_(std::move(server)) {}

  /// The best run on a level by the present rules, as far as names of files tell: nothing is read. So the recording may
  /// be one on another level with the same hash, or damaged.
  std::optional<StoredRun> bestByName(const Level& level) const;
  /// The runs on a level by the present rules, of the player's own games and on this server, by their names and levels,
  /// the one with the least time first. The recordings may turn out to be damaged, or no runs.
  std::vector<StoredRun> runsOn(const Level& level) const;
  /// The first of these.
  std::optional<StoredRun> best(const Level& level) const;
  /// Where `keep` writes a run.
  std::filesystem::path fileOf(const Run& run) const;
  /// Keeps a run as the best one, in place of slower ones. Returns why that failed, or an empty text.
  std::string keep(const Run& run);
  /// All runs on all servers, newest first, older rules included.
  std::vector<StoredRun> all() const;
  /// What the name of a run of an own game by the present rules tells; nothing if the file is none.
  std::optional<StoredRun> ownRunOf(const std::filesystem::path& file) const;

 private:
  std::filesystem::path serversFolder() const { return folder_ / "servers"; }
  /// Where the runs of this server are.
  std::filesystem::path keepFolder() const { return server_.empty() ? folder_ : serversFolder() / server_; }
  std::vector<StoredRun> candidates(const Level& level) const;
  void limit() const;
  void limitServers() const;

  std::filesystem::path folder_;
  std::string server_;
};

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
