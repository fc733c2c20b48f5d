#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "client/netcode/prediction.h"
#include "client/replay/level_ghosts.h"
#include "client/replay/run_cutter.h"
#include "client/replay/run_store.h"
#include "client/replay/run_track.h"
#include "client/scene/scene.h"
#include "client/ui/run_timer.h"
#include "protocol/work/worker.h"

namespace platon {

/// Keeps the local player's best run on each level, compares its attempts with it, and shows it and the runs of others
/// as ghosts. It only watches the game. Threads read, play and write the recordings. The thread of the game waits
/// for them only at a goal that is reached before the best run of the level has been read, and in `store`.
class RunKeeper : public ConfirmedObserver {
 public:
  /// Most ghosts of others.
  static constexpr std::size_t kMaxOthers = 3;
  /// How long a difference to the best run is shown: 2 s.
  static constexpr std::uint32_t kShownTicks = 2 * kTicksPerSecond;

  /// `ghosts`: a folder with runs of others. `rival`: a recording that is a ghost on its level besides those. Empty
  /// paths: there are none.
  RunKeeper(RunStore runs, std::filesystem::path ghosts, std::filesystem::path rival = {},
            const ThreadStart& start = &startThread)
      : saver_(std::move(runs), start),
        ghostFolder_(std::move(ghosts)),
        rivalFile_(std::move(rival)),
        loading_(start),
        loadingOthers_(start),
        tracking_(start) {}

  void began(const Game& confirmed, std::uint32_t slot) override;
  void advanced(std::span<const Input> inputs, const Game& confirmed) override;

  /// Whether attempts may become the best run; they may at first. Not: neither may the present one.
  void countRuns(bool count);

  /// How the attempt compares with the best run.
  RunStatus status() const;
  /// The ghosts `fraction` of a tick after the last but one of `game`, in which the attempt of the player in `slot`
  /// runs. None before its first input.
  std::vector<GhostSource> ghostsAt(const Game& game, std::uint32_t slot, double fraction) const;

  /// What could not be kept or read, each a sentence that is returned once.
  std::vector<std::string> takeFaults();
  /// The file of the best run on the level; empty: none. A new one is known when its file is written, and takeFaults
  /// has been called.
  const std::filesystem::path& bestFile() const { return bestFile_; }
  /// The runs that are kept; waits for the disk until all are.
  const RunStore& store();

 private:
  void load(std::shared_ptr<const Level> level);
  void takeBest(JobResult<LevelGhosts> read);
  void takeOthers(JobResult<LevelGhosts> read);
  void beginAttempt();
  void pollGhosts();
  void pollTrack();
  void pollFile();
  void observe(const Game& game, const PlayerState& player);
  void arrive(const Game& game, std::uint32_t ticks);
  std::string whyNotRecorded(std::uint32_t ticks) const;
  void show(std::uint32_t tick, std::int64_t difference);

  RunSaver saver_;
  std::filesystem::path ghostFolder_;
  std::filesystem::path rivalFile_;
  RunCutter cutter_;
  std::uint32_t slot_ = 0;
  std::shared_ptr<const Level> level_;  // of best_ and others_; null: none
  std::optional<Ghost> best_;
  std::optional<std::uint32_t> bestTicks_;  // its time; ahead of best_ while a thread reads or plays it
  std::filesystem::path bestFile_;
  std::filesystem::path unsavedFile_;         // of a new best run, while it is being written; empty: none
  bool isFileNew_ = false;                    // bestFile_ was written since the level has begun
  Worker<LevelGhosts> loading_;               // for these, when a level has begun
  Worker<LevelGhosts> loadingOthers_;         // for others_, after loading_: nobody waits for them
  Worker<std::optional<RunTrack>> tracking_;  // of a new best run, for best_
  std::vector<Ghost> others_;
  std::vector<std::string> faults_;
  std::uint32_t tick_ = 0;  // of the confirmed game

  // Of the attempt.
  std::uint32_t startedAt_ = 0;  // as PlayerState
  FaceVisits visits_;
  std::optional<Ghost> compared_;           // the best run when it began, or was read; it remains its ghost
  std::optional<std::int64_t> difference_;  // ticks, to compared_
  std::uint32_t differenceUntil_ = 0;       // tick
  bool isNewBest_ = false;
  std::string notRecorded_;  // as RunStatus
  bool counts_ = true;

  bool willCount_ = true;  // the next attempt
};

}  // namespace platon
