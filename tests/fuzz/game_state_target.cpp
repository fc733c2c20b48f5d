#include <algorithm>
#include <memory>
#include <string_view>
#include <utility>

#include "platon/game/game.h"
#include "tests/fuzz/byte_source.h"
#include "tests/fuzz/fuzz_targets.h"

namespace platon::fuzz {
namespace {

constexpr int kTicksAfter = 4;
constexpr std::size_t kMaxEdits = 24;

constexpr std::string_view kText =
    "TETRAHEDRON\n0 0 -55 0\n2 0 0\n240\n%\n-60 -69.2 60 -69.2\n-20 -30 20 -20\n-60 -69.2 -30 -69.2 plate 1\n"
    "-60 -20 -30 -20 oneway\n40 -69.2 40 -40 door 1\n%\n-30 0 30 10\n0 -60 0 -40 checkpoint\n20 -50 30 -50 key 2\n"
    "%\n-40 -30 40 -30 up 1\n-50 -60 50 -60 hazard\n%\n0 60 0 60\n0 -60 0 60 door 2\n-50 -40 50 -40 timed 2 3\n";

constexpr bool hasWord(ElementKind kind) {
  for (std::size_t at = kText.find(wordOf(kind)); at != kText.npos; at = kText.find(wordOf(kind), at + 1)) {
    const char after = kText[at + wordOf(kind).size()];
    if (kText[at - 1] == ' ' && (after == ' ' || after == '\n')) return true;
  }
  return false;
}
static_assert(std::all_of(kElementKinds.begin(), kElementKinds.end(), hasWord), "kText lacks a kind of element");

const std::shared_ptr<const Level>& level() {
  static const std::shared_ptr<const Level> loaded = loadLevel(kText).level;
  return loaded;
}

class LegCounter : public StepObserver {
 public:
  void leg(std::uint32_t, std::span<const InstanceView>) override { ++count_; }
  std::size_t take() { return std::exchange(count_, 0); }

 private:
  std::size_t count_ = 0;
};

std::vector<Input> inputsFrom(ByteSource& bytes, std::size_t slots) {
  std::vector<Input> inputs(slots);
  for (Input& input : inputs) input = validInput(bytes.byte());
  return inputs;
}

std::vector<std::uint8_t> editedSave(ByteSource& bytes) {
  Game game(level());
  const std::size_t slots = bytes.below(4) + 1;
  for (std::size_t ticks = bytes.below(64); ticks > 0; --ticks) game.advance(inputsFrom(bytes, slots));
  std::vector<std::uint8_t> saved = game.save();
  for (std::size_t edits = bytes.below(kMaxEdits); edits > 0; --edits) saved[bytes.below(saved.size())] = bytes.byte();
  return saved;
}

std::string continueFault(Game game, ByteSource& bytes) {
  LegCounter legs;
  for (int tick = 0; tick < kTicksAfter; ++tick) {
    game.advance(inputsFrom(bytes, std::min<std::size_t>(game.slots() + 1, kMaxPlayers)), &legs);
    if (legs.take() > 100 * std::size_t{game.slots()}) return "a step has too many legs";
    Game again(level());
    if (!again.restore(game.save()) || !(again == game)) return "a game continued from a state has an invalid state";
  }
  return {};
}

}  // namespace

std::string gameStateFault(Bytes input) {
  ByteSource bytes(input);
  std::vector<std::uint8_t> state;
  if (bytes.flag()) {
    state = editedSave(bytes);
  } else {
    const Bytes remaining = bytes.remaining();
    state.assign(remaining.begin(), remaining.end());
  }
  Game game(level());
  const std::uint64_t before = game.hash();
  if (!game.restore(state)) return game.hash() == before ? std::string() : "a refused state changes the game";
  if (game.save() != state) return "a restored state differs when saved again";
  return continueFault(game, bytes);
}

}  // namespace platon::fuzz
