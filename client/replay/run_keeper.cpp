#include "client/replay/run_keeper.h"

#include <system_error>

#include "client/netcode/player_snapshot.h"
#include "client/replay/replay.h"

namespace platon {
void RunKeeper::began(const Game& confirmed, std::uint32_t slot) {
  slot_ = slot;
  tick_ = confirmed.tick();
  cutter_.begin(confirmed, slot);
  if (!level_ || !isSameLevel(*level_, confirmed.level())) load(confirmed.sharedLevel());
  beginAttempt();
}

void RunKeeper::countRuns(bool count) {
  willCount_ = count;
  counts_ = counts_ && count;
}

// The name of the file tells the time of the best run at once.
void RunKeeper::load(std::shared_ptr<const Level> level) {
  level_ = std::move(level);
  tracking_.drop();
  loadingOthers_.drop();
  best_.reset();
  others_.clear();
  const BestRunSource source{saver_.store(), saver_.unsavedOn(*level_)};
  const std::optional<StoredRun> stored = source.own.bestByName(*level_);
  bestFile_ = stored ? stored->file : std::filesystem::path();
  bestTicks_ = stored ? std::optional(stored->ticks) : std::nullopt;
  unsavedFile_ = source.unsaved ? source.own.fileOf(*source.unsaved) : std::filesystem::path();
  if (source.unsaved) bestTicks_ = source.unsaved->ticks;
  isFileNew_ = false;
  loading_.restart(
      [source, played = level_](const std::stop_token& stop) { return readBestGhost(source, *played, stop); });
}

// An attempt that has begun meanwhile is compared with the best run from now on. The thread may have found the file
// that a run written meanwhile has replaced.
void RunKeeper::takeBest(JobResult<LevelGhosts> read) {
  const OtherRunsSource others{ghostFolder_, rivalFile_, read.value ? read.value->bestFile : std::filesystem::path()};
  loadingOthers_.restart([others, played = level_](const std::stop_token& stop) {
    return readOtherGhosts(others, *played, kMaxOthers, stop);
  });
  if (!read.value) return faults_.push_back("cannot show the best run as a ghost: " + read.fault);
  best_ = std::move(read.value->best);
  bestTicks_ = best_ ? std::optional(best_->track->ticks) : std::nullopt;
  if (!best_ || !isFileNew_) bestFile_ = best_ ? std::move(read.value->bestFile) : std::filesystem::path();
  for (std::string& fault : read.value->faults) faults_.push_back(std::move(fault));
  if (!compared_) compared_ = best_;
}

void RunKeeper::takeOthers(JobResult<LevelGhosts> read) {
  if (!read.value) return faults_.push_back("cannot show the runs of others as ghosts: " + read.fault);
  others_ = std::move(read.value->others);
  for (std::string& fault : read.value->faults) faults_.push_back(std::move(fault));
}

void RunKeeper::pollGhosts() {
  if (auto read = loading_.poll()) takeBest(std::move(*read));
  if (auto read = loadingOthers_.poll()) takeOthers(std::move(*read));
}

void RunKeeper::pollTrack() {
  std::optional<JobResult<std::optional<RunTrack>>> track = tracking_.poll();
  if (!track) return;
  if (track->value && *track->value) best_ = bestGhostOf(std::move(**track->value));
  if (!track->fault.empty()) faults_.push_back("cannot show the best run as a ghost: " + track->fault);
}

// If it could not be written, the file of the best run remains the one before.
void RunKeeper::pollFile() {
  if (unsavedFile_.empty() || saver_.isPending()) return;
  std::error_code ignored;
  isFileNew_ = std::filesystem::exists(unsavedFile_, ignored);
  if (isFileNew_) bestFile_ = std::move(unsavedFile_);
  unsavedFile_.clear();
}

// Called in each tick before the first input, so a new best run is the one to compare with as soon as it is played.
void RunKeeper::beginAttempt() {
  pollGhosts();
  pollTrack();
  startedAt_ = 0;
  visits_ = FaceVisits();
  compared_ = best_;
  difference_.reset();
  isNewBest_ = false;
  notRecorded_.clear();
  counts_ = willCount_;
}

void RunKeeper::advanced(std::span<const Input> inputs, const Game& confirmed) {
  const std::optional<std::uint32_t> arrival = cutter_.advance(inputs, confirmed);
  pollGhosts();
  tick_ = confirmed.tick();
  if (slot_ >= confirmed.slots()) return;
  observe(confirmed, confirmed.player(slot_));
  if (arrival) arrive(confirmed, *arrival);
}

void RunKeeper::observe(const Game& game, const PlayerState& player) {
  const bool continues = player.startedAt == startedAt_ || startedAt_ == 0;
  if (player.startedAt == 0 || !continues) beginAttempt();
  startedAt_ = player.startedAt;
  if (player.present == 0 || player.arrived != 0) return;
  const std::uint32_t face = game.world().entities()[slot_].part;
  if (!visits_.enters(face) || startedAt_ == 0 || !compared_) return;
  if (const Split* split = compared_->track->splitOf(face))
    show(tick_, std::int64_t{tick_} - startedAt_ + 1 - split->ticks);
}

void RunKeeper::show(std::uint32_t tick, std::int64_t difference) {
  difference_ = difference;
  differenceUntil_ = tick + kShownTicks;
}

// The difference at the goal is shown until the next attempt.
void RunKeeper::arrive(const Game& game, std::uint32_t ticks) {
  if (loading_.isPending()) {
    if (auto read = loading_.wait()) takeBest(std::move(*read));
  }
  if (compared_) {
    show(tick_, std::int64_t{ticks} - compared_->track->ticks);
    differenceUntil_ = UINT32_MAX;
  }
  if (!counts_ || (bestTicks_ && *bestTicks_ <= ticks)) return;
  std::optional<Run> run = cutter_.cut(game);
  if (!run) return void(notRecorded_ = whyNotRecorded(ticks));
  isNewBest_ = true;
  bestTicks_ = ticks;
  tracking_.restart([recording = run->recording](const std::stop_token& stop) { return trackIn(recording, stop); });
  unsavedFile_ = saver_.store().fileOf(*run);
  saver_.keep(std::move(*run));
}

// Of an attempt that would be the best run, but was not cut.
std::string RunKeeper::whyNotRecorded(std::uint32_t ticks) const {
  if (ticks > RunCutter::kMaxTicks) return "too long to be recorded";
  return cutter_.isGroupTooCostly() ? "too many players to be recorded" : "";
}

std::vector<std::string> RunKeeper::takeFaults() {
  if (const std::optional<std::string> fault = saver_.poll()) faults_.push_back("cannot save the best run: " + *fault);
  pollFile();
  return std::exchange(faults_, {});
}

const RunStore& RunKeeper::store() {
  saver_.finish();
  return saver_.store();
}

RunStatus RunKeeper::status() const {
  RunStatus status;
  if (bestTicks_) status.best = secondsOf(*bestTicks_);
  if (difference_ && tick_ < differenceUntil_) status.difference = secondsOf(static_cast<double>(*difference_));
  status.isNewBest = isNewBest_;
  status.notRecorded = notRecorded_;
  return status;
}

std::vector<GhostSource> RunKeeper::ghostsAt(const Game& game, std::uint32_t slot, double fraction) const {
  std::vector<GhostSource> ghosts;
  const bool runs = slot < game.slots() && game.player(slot).startedAt != 0;
  if (!runs || !level_ || !isSameLevel(game.level(), *level_)) return ghosts;
  const std::uint32_t ticks = game.tick() - game.player(slot).startedAt + 1;
  const auto add = [&](const Ghost& ghost, bool isBest) {
    ghosts.push_back({ghost.track->at(ticks, fraction), ghost.name, isBest});
  };
  if (compared_) add(*compared_, true);
  for (const Ghost& other : others_) add(other, false);
  return ghosts;
}

}  // namespace platon
