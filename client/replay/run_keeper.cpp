#include "client/replay/run_keeper.h"

#include <variant>

#include "client/replay/replay_file.h"
#include "client/replay/same_level.h"
#include "client/replay/track_file.h"
#include "client/ui/player_rows.h"

namespace platon {
namespace {

double secondsOf(double ticks) { return ticks / kTicksPerSecond; }

Ghost ghostOf(RunTrack track) {
  const std::string name = "best " + finishText(secondsOf(track.ticks));
  return {name, std::make_shared<RunTrack>(std::move(track))};
}

// The run of a recording that this program has made.
std::optional<RunTrack> trackIn(const std::vector<std::uint8_t>& recording, const std::stop_token& stop) {
  const auto read = Replay::read(recording, stop);
  const auto* const replay = std::get_if<std::shared_ptr<const Replay>>(&read);
  return replay == nullptr ? std::nullopt : trackOf(**replay);
}

}  // namespace

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

void RunKeeper::load(std::shared_ptr<const Level> level) {
  level_ = std::move(level);
  takeTrack();  // of the level before
  best_ = readBest();
  bestTicks_ = best_ ? std::optional(best_->track->ticks) : std::nullopt;
  others_ = ghostsIn(ghostFolder_, *level_, kMaxOthers, faults_);
  addRival();
}

// It may be among the others, or the best run.
void RunKeeper::addRival() {
  const std::optional<RecordingHead> head = rivalFile_.empty() ? std::nullopt : readRecordingHeadOf(rivalFile_);
  if (!head || !head->level || !isSameLevel(*head->level, *level_)) return;
  const std::optional<StoredRun> stored = store().best(*level_);
  if (stored && stored->file == rivalFile_) return;
  auto track = readTrack(rivalFile_, level_.get());
  if (auto* fault = std::get_if<std::string>(&track)) return faults_.push_back(std::move(*fault));
  Ghost rival = makeGhost(rivalFile_, std::get<RunTrack>(std::move(track)));
  std::erase_if(others_, [&](const Ghost& other) { return other.name == rival.name; });
  others_.insert(others_.begin(), std::move(rival));
}

std::optional<Ghost> RunKeeper::readBest() {
  const std::optional<StoredRun> stored = store().best(*level_);
  if (!stored) return std::nullopt;
  auto track = readTrack(stored->file, level_.get());
  if (auto* run = std::get_if<RunTrack>(&track)) return ghostOf(std::move(*run));
  faults_.push_back(std::get<std::string>(std::move(track)));
  return std::nullopt;
}

// Usually done long ago: the attempt before has ended some time before the next one begins.
void RunKeeper::takeTrack() {
  if (!tracking_.isPending()) return;
  JobResult<std::optional<RunTrack>> track = tracking_.wait();
  if (track.value && *track.value) best_ = ghostOf(std::move(**track.value));
  if (!track.fault.empty()) faults_.push_back("the best run is no ghost: " + track.fault);
}

void RunKeeper::beginAttempt() {
  takeTrack();
  startedAt_ = 0;
  visits_ = FaceVisits();
  rival_ = best_;
  difference_.reset();
  isNewBest_ = tooLong_ = false;
  counts_ = willCount_;
}

void RunKeeper::advanced(std::span<const Input> inputs, const Game& confirmed) {
  const std::optional<std::uint32_t> arrival = cutter_.advance(inputs, confirmed);
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
  if (!visits_.enters(face) || startedAt_ == 0 || !rival_) return;
  if (const Split* split = rival_->track->splitOf(face))
    show(tick_, std::int64_t{tick_} - startedAt_ + 1 - split->ticks);
}

void RunKeeper::show(std::uint32_t tick, std::int64_t difference) {
  difference_ = difference;
  differenceUntil_ = tick + kShownTicks;
}

// The difference at the goal is shown until the next attempt.
void RunKeeper::arrive(const Game& game, std::uint32_t ticks) {
  if (rival_) {
    show(tick_, std::int64_t{ticks} - rival_->track->ticks);
    differenceUntil_ = UINT32_MAX;
  }
  if (!counts_ || (bestTicks_ && *bestTicks_ <= ticks)) return;
  tooLong_ = ticks > RunCutter::kMaxTicks;
  std::optional<Run> run = cutter_.cut(game);
  if (!run) return;
  isNewBest_ = true;
  bestTicks_ = ticks;
  tracking_ = Job<std::optional<RunTrack>>(
      [recording = run->recording](const std::stop_token& stop) { return trackIn(recording, stop); });
  saver_.keep(std::move(*run));
}

std::vector<std::string> RunKeeper::takeFaults() {
  if (const std::optional<std::string> fault = saver_.poll()) faults_.push_back("the best run is not kept: " + *fault);
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
  status.tooLong = tooLong_;
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
  if (rival_) add(*rival_, true);
  for (const Ghost& other : others_) add(other, false);
  return ghosts;
}

}  // namespace platon
