#include "client/replay/replay.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "client/replay/recording_fault.h"

namespace platon {
namespace {

// So that no tick is above 2^32.
constexpr std::uint32_t kMaxFirstTick = UINT32_MAX - PlayCost::kMax / PlayCost::kBase;

// What a round of 256 players costs, as PlayCost::add counts it.
constexpr std::uint64_t costOfFullRound(std::uint64_t segments) {
  return std::uint64_t{kRoundTicks} * (kMaxPlayers + 1) * (PlayCost::kBase + segments);
}

static_assert(costOfFullRound(31) <= PlayCost::kMax && costOfFullRound(32) > PlayCost::kMax, "mend the text of kMax");

}  // namespace

std::optional<Game> gameBefore(const RecordedBlock& first, const std::shared_ptr<const Level>& level) {
  Game game(level);
  const bool valid = game.restore(first.state) && game.tick() == first.firstTick && game.tick() <= kMaxFirstTick;
  return valid ? std::optional(std::move(game)) : std::nullopt;
}

bool PlayCost::add(std::uint32_t ticks, std::uint32_t slots) {
  slots_ = std::max(slots_, slots);
  sum_ += ticks * (std::uint64_t{slots_} + 1) * ofPlayer_;
  return sum_ <= kMax;
}

std::variant<std::shared_ptr<const Replay>, std::string> Replay::read(std::span<const std::uint8_t> recording,
                                                                      const std::stop_token& stop,
                                                                      ReplayProgress* progress) {
  RecordingReader reader(recording);
  std::optional<RecordedBlock> first = reader.next();
  if (!first) return recordingFault(reader, recording);
  std::optional<Game> start = gameBefore(*first, reader.level());
  if (!start) return kNoStart;
  const std::shared_ptr<Replay> replay(new Replay(std::move(*start)));
  std::string fault = replay->readBlocks(reader, std::move(*first), stop);
  if (fault.empty()) fault = recordingFault(reader, recording);
  if (fault.empty()) fault = replay->play(stop, progress);
  if (!fault.empty()) return fault;
  return replay;
}

std::string Replay::readBlocks(RecordingReader& reader, RecordedBlock first, const std::stop_token& stop) {
  std::string fault = add(std::move(first));
  while (fault.empty()) {
    if (stop.stop_requested()) return kStopped;
    std::optional<RecordedBlock> block = reader.next();
    if (!block) break;
    fault = add(std::move(*block));
  }
  return fault;
}

std::string Replay::add(RecordedBlock block) {
  ticks_ += block.ticks();
  const bool affordable = cost_.add(block.ticks(), block.slots);
  blocks_.push_back(std::move(block));
  return affordable ? "" : kTooLong;
}

// Plays it once. The recorded states and hashes must be those of this program.
std::string Replay::play(const std::stop_token& stop, ReplayProgress* progress) {
  interval_ = std::max(kMinInterval, ticks_ / (kMaxStates - 1) + 1);
  Game game = start_;
  Game before = start_;  // the last tick
  RecordedRun run(start_);
  std::uint32_t tick = 0;
  const auto differs = [&] {
    return damagedText("it does not give the recorded game at tick " + std::to_string(game.tick()));
  };
  for (RecordedBlock& block : blocks_) {
    if (game.save() != block.state) return differs();
    for (std::uint32_t i = 0; i < block.ticks(); ++i, ++tick) {
      if (stop.stop_requested()) return kStopped;
      if (progress != nullptr) *progress = static_cast<std::uint32_t>(std::uint64_t{tick} * 100 / ticks_);
      if (tick % interval_ == 0) states_.push_back(game.save());
      if (tick + 1 == ticks_) before = game;
      run.add(block.inputsOf(i));
      game.advance(block.inputsOf(i));
      if (game.hash() != block.hashes[i]) return differs();
    }
    block.hashes = {};
    block.state = {};
  }
  if (tick % interval_ == 0) states_.push_back(game.save());
  run_ = run.finish(before, game);
  return {};
}

std::span<const Input> Replay::inputsOf(std::uint32_t tick) const {
  const std::uint32_t recorded = start_.tick() + tick;
  const auto next = std::upper_bound(blocks_.begin(), blocks_.end(), recorded,
                                     [](std::uint32_t at, const RecordedBlock& block) { return at < block.firstTick; });
  const RecordedBlock& block = *std::prev(next);
  return block.inputsOf(recorded - block.firstTick);
}

Game Replay::gameAfter(std::uint32_t tick) const {
  Game game(level());
  std::uint32_t reached = tick / interval_ * interval_;
  game.restore(states_[reached / interval_]);
  for (; reached < tick; ++reached) game.advance(inputsOf(reached));
  return game;
}

}  // namespace platon
