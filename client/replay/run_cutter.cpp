#include "client/replay/run_cutter.h"

#include <algorithm>
#include <variant>

#include "client/replay/replay.h"
#include "platon/game/recorder.h"

namespace platon {

namespace {

std::uint32_t timeOf(const PlayerState& player, const Game& game) { return game.tick() - player.startedAt + 1; }

bool presses(Input input, Input before, std::uint8_t button) { return input.has(button) && !before.has(button); }

}  // namespace

std::optional<RunCutter::Own> RunCutter::ownIn(const Game& game) const {
  if (slot_ >= game.slots() || game.player(slot_).present == 0) return std::nullopt;
  return Own{game.world().entities()[slot_], game.player(slot_)};
}

void RunCutter::begin(const Game& game, std::uint32_t slot) {
  slot_ = slot;
  own_ = ownIn(game);
  known_ = false;
  inputs_.clear();
  groupInputs_.clear();
  const bool isShared = game.level().doorNumbers != 0 || game.level().isTimed;
  start_ = isShared ? std::optional(game) : std::nullopt;
  rest_.reset();
  if (start_ || (own_ && own_->player.startedAt == 0)) rest_.emplace(game.sharedLevel());
  // A player who has pressed nothing since it came has only fallen.
  const std::optional<std::uint32_t> ticks = rest_ ? rest_->ticksTo(game, slot_) : std::nullopt;
  known_ = ticks.has_value();
  if (ticks) inputs_.assign(*ticks, Input{Input::kPresent});
}

std::optional<std::uint32_t> RunCutter::advance(std::span<const Input> inputs, const Game& game) {
  const std::optional<Own> own = ownIn(game);
  const bool arrives = own && own->player.arrived != 0 && (!own_ || own_->player.arrived == 0);
  if (own) followOwn(inputs[slot_], *own);
  own_ = own;
  followGroup(inputs, game);
  return arrives ? std::optional(timeOf(own->player, game)) : std::nullopt;
}

void RunCutter::followOwn(Input input, const Own& own) {
  const Input before{own_ ? own_->player.held : std::uint8_t{0}};
  if (!own_ || presses(input, before, Input::kRestart)) {
    // A button that is held when the player restarts is not pressed again: the tick before is a part of the run.
    inputs_.clear();
    if (own_) inputs_.push_back({static_cast<std::uint8_t>((before.buttons & ~Input::kRestart) | Input::kPresent)});
    known_ = true;
  } else if (own.player.startedAt == 0 && own == *own_) {
    return;  // rests: the tick changes nothing
  }
  if (own_ && own_->player.arrived != 0 && own.player.arrived != 0) return;
  known_ = known_ && inputs_.size() < kMaxTicks;
  if (known_) inputs_.push_back(input);
}

void RunCutter::followGroup(std::span<const Input> inputs, const Game& game) {
  if (!start_) return;
  groupInputs_.emplace_back(inputs.begin(), inputs.end());
  if (groupInputs_.size() < kMinGroupTicks || (!allRest(game) && groupInputs_.size() < kMaxGroupTicks)) return;
  start_ = game;
  groupInputs_.clear();
}

// Whether no attempt is under way, and a recording that begins here shows it.
bool RunCutter::allRest(const Game& game) const {
  for (std::uint32_t slot = 0; slot < game.slots(); ++slot) {
    const PlayerState& player = game.player(slot);
    if (player.startedAt != 0 || (player.present != 0 && !rest_->ticksTo(game, slot))) return false;
  }
  return true;
}

std::optional<Run> RunCutter::cut(const Game& game) const {
  std::optional<Run> run = cutAlone(game);
  return run ? run : cutGroup(game);
}

// Nothing if this player alone would not have reached the goal like that.
std::optional<Run> RunCutter::cutAlone(const Game& game) const {
  if (!known_ || !own_) return std::nullopt;
  Game alone(game.sharedLevel());
  Recorder recorder(alone, kCheckpointTicks);
  for (const Input& input : inputs_) {
    alone.advance({&input, 1});
    recorder.record({&input, 1}, alone);
  }
  recorder.finish(alone);
  const std::uint32_t ticks = timeOf(own_->player, game);
  const EntityState& entity = alone.world().entities()[0];
  const bool same = entity.part == own_->entity.part && entity.position == own_->entity.position;
  if (!same || alone.player(0).arrived == 0 || alone.player(0).finishTicks != ticks) return std::nullopt;
  return Run{game.sharedLevel(), ticks, recorder.takeBytes()};
}

// Whether the group's game has been followed since before the attempt.
bool RunCutter::isInGroup() const { return start_ && own_ && own_->player.startedAt > start_->tick(); }

// Counts by blocks, as whoever reads the recording does.
bool RunCutter::isGroupAffordable() const {
  PlayCost cost(*start_);
  bool affordable = true;
  for (std::size_t first = 0; first < groupInputs_.size(); first += kCheckpointTicks) {
    const auto ticks = std::min<std::size_t>(kCheckpointTicks, groupInputs_.size() - first);
    std::size_t slots = 0;
    for (std::size_t i = first; i < first + ticks; ++i) slots = std::max(slots, groupInputs_[i].size());
    affordable = cost.add(static_cast<std::uint32_t>(ticks), static_cast<std::uint32_t>(slots));
  }
  return affordable;
}

std::optional<Run> RunCutter::cutGroup(const Game& game) const {
  if (!isInGroup() || !isGroupAffordable()) return std::nullopt;
  Game group = *start_;
  Game before = group;
  RecordedRun run(group);
  Recorder recorder(group, kCheckpointTicks);
  for (const std::vector<Input>& inputs : groupInputs_) {
    if (&inputs == &groupInputs_.back()) before = group;
    group.advance(inputs);
    run.add(inputs);
    recorder.record(inputs, group);
  }
  if (!std::holds_alternative<RunFinish>(run.finish(before, group))) return std::nullopt;
  recorder.finish(group);
  return Run{game.sharedLevel(), timeOf(own_->player, game), recorder.takeBytes()};
}

}  // namespace platon
