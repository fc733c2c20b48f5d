#include "platon/game/recorded_run.h"

#include <algorithm>
#include <utility>

namespace platon {
namespace {

bool hasArrived(const Game& game, std::uint32_t slot) { return slot < game.slots() && game.player(slot).arrived != 0; }

// Who touches the goal in the tick from `before` to `after`.
std::optional<std::uint32_t> runnerOf(const Game& before, const Game& after) {
  for (std::uint32_t slot = 0; slot < after.slots(); ++slot) {
    if (hasArrived(after, slot) && !hasArrived(before, slot)) return slot;
  }
  return std::nullopt;
}

// Place of the instance with this id among those of an entity, the home instance first.
std::uint16_t placeOf(std::uint16_t id, const EntityState& entity, std::span<const InstanceState> further) {
  if (id == InstanceState::kNoParent) return id;
  if (id == entity.id) return 0;
  const auto found = std::find_if(further.begin(), further.end(), [id](const auto& each) { return each.id == id; });
  return static_cast<std::uint16_t>(found - further.begin() + 1);
}

// The level with timed segments that are always solid, or never.
std::shared_ptr<const Level> withTimed(const Level& level, std::uint16_t solid) {
  auto changed = std::make_shared<Level>(level);
  for (Element& element : changed->elements) {
    if (element.kind != ElementKind::kTimed) continue;
    element.number = solid;
    element.openTicks = static_cast<std::uint16_t>(1 - solid);
  }
  return changed;
}

}  // namespace

// Without the names and counts that an entity keeps when it returns to the start: instances are named by their places.
LevelRest::Stay LevelRest::stayOf(const Game& game, std::uint32_t slot) {
  const auto instances = game.world().instancesOf(slot);
  Stay stay{game.world().entities()[slot], {instances.begin(), instances.end()}, game.player(slot)};
  for (InstanceState& instance : stay.instances) instance.parent = placeOf(instance.parent, stay.entity, instances);
  for (InstanceState& instance : stay.instances) instance.id = 0;
  stay.entity.id = stay.entity.nextId = 0;
  stay.entity.crossings = 0;
  stay.player.held = 0;
  stay.player.finishTicks = 0;
  return stay;
}

// A player that goes through the same whether all timed segments are solid or none meets none of them, whenever it
// comes.
LevelRest::LevelRest(const std::shared_ptr<const Level>& level) {
  if (!level->isTimed) {
    play(level);
    return;
  }
  play(withTimed(*level, 0));
  const std::vector<Stay> withoutTimed = std::exchange(stays_, {});
  opened_.clear();
  play(withTimed(*level, 1));
  if (stays_ == withoutTimed) return;
  stays_.clear();
  opened_.clear();
}

void LevelRest::play(const std::shared_ptr<const Level>& level) {
  const Input rest{Input::kPresent};
  Game game(level);
  while (stays_.size() < kMaxTicks) {
    game.advance({&rest, 1});
    opened_.push_back({game.takenKeys(), game.pressedPlates()});
    Stay stay = stayOf(game, 0);
    const bool rests = !stays_.empty() && stay == stays_.back();
    stays_.push_back(std::move(stay));
    if (rests && level->elements.empty()) return;
  }
}

std::optional<std::uint32_t> LevelRest::ticksTo(const Game& game, std::uint32_t slot) const {
  if (slot >= game.slots() || game.player(slot).present == 0) return std::nullopt;
  const auto found = std::find(stays_.begin(), stays_.end(), stayOf(game, slot));
  if (found == stays_.end()) return std::nullopt;
  return static_cast<std::uint32_t>(found - stays_.begin()) + 1;
}

bool LevelRest::explainsDoorsOf(const Game& game) const {
  Opened explained;
  for (std::uint32_t slot = 0; slot < game.slots(); ++slot) {
    if (game.player(slot).present == 0) continue;
    const Stay stay = stayOf(game, slot);
    for (std::size_t i = 0; i < stays_.size(); ++i) {
      if (stays_[i] != stay) continue;
      explained.keys |= opened_[i].keys;
      explained.plates |= opened_[i].plates;
    }
  }
  return (game.takenKeys() & ~explained.keys) == 0 && (game.pressedPlates() & ~explained.plates) == 0;
}

RecordedRun::RecordedRun(const Game& start) : start_(start), tick_(start.tick()), found_(start.slots()) {
  for (std::uint32_t slot = 0; slot < start.slots(); ++slot) {
    const PlayerState& player = start.player(slot);
    found_[slot] = {player.held, player.present != 0 ? UINT32_MAX : 0};
  }
}

void RecordedRun::add(std::span<const Input> inputs) {
  ++tick_;
  for (std::size_t slot = 0; slot < found_.size(); ++slot) {
    Found& found = found_[slot];
    if (found.renewedAt != UINT32_MAX) continue;
    const Input input = slot < inputs.size() ? inputs[slot] : Input();
    const bool restarts = input.has(Input::kRestart) && (found.held & Input::kRestart) == 0;
    if (restarts || !input.has(Input::kPresent)) found.renewedAt = tick_;
    found.held = input.buttons;
  }
}

std::variant<RunFinish, std::string> RecordedRun::finish(const Game& before, const Game& end) const {
  const std::optional<std::uint32_t> slot = runnerOf(before, end);
  if (!slot) return "is no run: it does not end with a player at the goal";
  const std::uint32_t startedAt = end.player(*slot).startedAt;
  if (startedAt <= start_.tick()) return "is no run: its attempt began before the recording";
  std::string fault = faultOf(*slot, startedAt);
  if (!fault.empty()) return fault;
  return RunFinish{*slot, end.tick() - startedAt + 1};
}

// Whether the attempt from tick `startedAt` meets the player as it was found, or what it has opened: a key stays taken
// if another player has begun before the restart, also in the same tick.
bool RecordedRun::isThere(std::uint32_t slot, std::uint32_t startedAt) const {
  if (slot >= found_.size()) return false;
  const bool hasDoors = start_.level().doorNumbers != 0;
  return hasDoors ? found_[slot].renewedAt >= startedAt : found_[slot].renewedAt > startedAt;
}

std::string RecordedRun::faultOf(std::uint32_t runner, std::uint32_t startedAt) const {
  const Level& level = start_.level();
  const bool hasDoors = level.doorNumbers != 0;
  std::optional<LevelRest> rest;
  for (std::uint32_t slot = 0; slot < found_.size(); ++slot) {
    if ((slot != runner && !hasDoors) || !isThere(slot, startedAt)) continue;
    if (!rest) rest.emplace(start_.sharedLevel());
    if (rest->ticksTo(start_, slot)) continue;
    return slot == runner
               ? "is no run: its player does not begin at the start of the level, at rest"
               : "is no run: another player, who can open doors, does not begin at the start of the level, at rest";
  }
  if (start_.openDoors() == 0) return {};
  if (!rest) rest.emplace(start_.sharedLevel());
  return rest->explainsDoorsOf(start_) ? std::string() : "is no run: doors are open at its beginning";
}

}  // namespace platon
