// Saving a game and restoring it from valid and invalid bytes.
#include <gtest/gtest.h>

#include <string>

#include "platon/game/game.h"
#include "tests/shared/game/played_game.h"
#include "tests/sim/button_presses.h"

namespace platon::game_restore_test {
namespace {

constexpr std::uint64_t kSeed = 616;

std::shared_ptr<const Level> level() {
  const std::string lines = "-240 -200 240 -200\n-150 -140 -40 -140\n60 -90 150 -90\n-100 20 100 40\n-200 100 -150 180";
  static const auto loaded = cubeLevel("0 0 -180 0", {lines, lines, lines, lines, lines, lines}, "2 0 100");
  return loaded;
}

// A game of five slots, advanced until its players have at least two instances besides the home instance.
Game playedToAnEdge() {
  Game game(level());
  std::vector<sim::ButtonPresses> presses;
  for (std::uint32_t slot = 0; slot < 5; ++slot) presses.emplace_back(kSeed, slot);
  while (game.tick() < 100 || game.world().save().instances.size() < 2) {
    std::vector<Input> inputs;
    for (auto& press : presses) inputs.push_back(press.next());
    inputs[3] = Input();
    game.advance(inputs);
  }
  return game;
}

std::vector<Input> someInputs(const Game& game, sim::SeededRandom& random) {
  std::vector<Input> inputs(game.slots());
  for (Input& input : inputs) input.buttons = static_cast<std::uint8_t>(random.below(32) | Input::kPresent);
  return inputs;
}

TEST(GameRestoreTest, TheRestoredGameIsTheSameAtEveryTick) {
  Game game(level());
  Game other(level());
  std::vector<sim::ButtonPresses> presses;
  for (std::uint32_t slot = 0; slot < 3; ++slot) presses.emplace_back(kSeed, slot);
  sim::SeededRandom random(kSeed);
  for (int tick = 0; tick < 700; ++tick) {
    std::vector<Input> inputs;
    for (auto& press : presses) inputs.push_back(random.below(60) == 0 ? Input() : press.next());
    game.advance(inputs);
    const auto bytes = game.save();
    ASSERT_TRUE(other.restore(bytes)) << "seed " << kSeed << ", tick " << tick;
    ASSERT_EQ(other, game);
    ASSERT_EQ(other.hash(), game.hash());
    ASSERT_EQ(other.save(), bytes);
    Game ahead = game;
    for (int step = 0; step < 3; ++step) {
      const auto next = someInputs(game, random);
      ahead.advance(next);
      other.advance(next);
    }
    ASSERT_EQ(ahead, other) << "seed " << kSeed << ", tick " << tick;
  }
}

TEST(GameRestoreTest, RestoresAFinishedRound) {
  Game game(level());
  for (std::uint32_t tick = 0; tick < kRoundTicks; ++tick) game.advance({});
  ASSERT_TRUE(game.over());
  Game other(level());
  ASSERT_TRUE(other.restore(game.save()));
  EXPECT_TRUE(other.over());
}

TEST(GameRestoreTest, AStateOf64PlayersIsSmallerThan8Kilobytes) {
  Game game(level());
  const std::vector<Input> inputs(64, Input{Input::kPresent | Input::kRight});
  for (int tick = 0; tick < 100; ++tick) game.advance(inputs);
  EXPECT_LT(game.save().size(), 8192u);
}

TEST(GameRestoreTest, RefusesEveryWrongLength) {
  const Game saved = playedToAnEdge();
  auto bytes = saved.save();
  Game game(level());
  game.advance(std::vector<Input>(2, Input{Input::kPresent}));
  const Game before = game;
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    ASSERT_FALSE(game.restore(std::span(bytes).first(length))) << length;
    ASSERT_EQ(game, before);
  }
  bytes.push_back(0);
  EXPECT_FALSE(game.restore(bytes));
  EXPECT_EQ(game, before);
}

TEST(GameRestoreTest, RefusesTooManyPlayers) {
  Game game(level());
  const std::vector<std::uint8_t> tooMany{0x01, 0x01};
  EXPECT_FALSE(game.restore(tooMany));
  const std::vector<std::uint8_t> huge(100000, 0xff);
  EXPECT_FALSE(game.restore(huge));
  const std::vector<std::uint8_t> zeros(100000, 0);
  EXPECT_FALSE(game.restore(zeros));
}

TEST(GameRestoreTest, AStateOfAnotherLevelIsRefusedOrPlayable) {
  Game tetrahedron(levelOf("TETRAHEDRON\n0 0 0 0\n1 0 0\n480\n%\n%\n%\n%\n"));
  const Game saved = playedToAnEdge();
  if (tetrahedron.restore(saved.save())) tetrahedron.advance({});
  EXPECT_EQ(tetrahedron.level().solid, SolidKind::kTetrahedron);
}

TEST(GameRestoreTest, EveryRestoredByteChangesTheHash) {
  const Game saved = playedToAnEdge();
  const auto bytes = saved.save();
  int accepted = 0;
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    for (const int bit : {0, 3, 7}) {
      auto changed = bytes;
      changed[at] = static_cast<std::uint8_t>(changed[at] ^ (1 << bit));
      Game game(level());
      if (!game.restore(changed)) continue;
      ++accepted;
      ASSERT_EQ(game.save(), changed) << at;
      ASSERT_NE(game.hash(), saved.hash()) << "byte " << at << ", bit " << bit;
      ASSERT_FALSE(game == saved);
      for (std::uint32_t slot = 0; slot < game.slots(); ++slot) {
        ASSERT_EQ(game.player(slot).present, game.world().entities()[slot].inserted)
            << "byte " << at << ", bit " << bit;
      }
    }
  }
  EXPECT_GT(accepted, 500);
}

// Changed bytes are either refused, and the game is unchanged, or give a state that can be advanced.
TEST(GameRestoreTest, RandomChangesAreRefusedOrPlayable) {
  const Game saved = playedToAnEdge();
  const auto valid = saved.save();
  sim::SeededRandom random(kSeed);
  int accepted = 0;
  Game game = saved;
  for (int round = 0; round < 100000; ++round) {
    auto bytes = valid;
    const std::uint64_t changes = 1 + random.below(4);
    for (std::uint64_t change = 0; change < changes; ++change) {
      bytes[random.below(bytes.size())] = static_cast<std::uint8_t>(random.next());
    }
    if (random.below(50) == 0) bytes.resize(random.below(bytes.size()));
    if (!game.restore(bytes)) continue;
    ++accepted;
    ASSERT_EQ(game.save(), bytes) << "seed " << kSeed << ", round " << round;
    game.advance(someInputs(game, random));
    game.advance(someInputs(game, random));
    Game again(level());
    ASSERT_TRUE(again.restore(game.save())) << "seed " << kSeed << ", round " << round;
  }
  EXPECT_GT(accepted, 10000);
  EXPECT_LT(accepted, 99000);
}

TEST(GameRestoreTest, RefusedBytesLeaveTheGameUnchanged) {
  const Game saved = playedToAnEdge();
  const auto valid = saved.save();
  sim::SeededRandom random(kSeed + 1);
  Game game = saved;
  for (int round = 0; round < 20000; ++round) {
    auto bytes = valid;
    for (int change = 0; change < 8; ++change)
      bytes[random.below(bytes.size())] = static_cast<std::uint8_t>(random.next());
    if (game.restore(bytes)) {
      game = saved;
    } else {
      ASSERT_EQ(game, saved) << "seed " << kSeed + 1 << ", round " << round;
    }
  }
}

TEST(GameRestoreTest, RandomBytesAreRefusedOrPlayable) {
  sim::SeededRandom random(kSeed);
  Game game(level());
  for (int round = 0; round < 20000; ++round) {
    std::vector<std::uint8_t> bytes(random.below(400));
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random.next() >> random.below(60));
    if (game.restore(bytes)) game.advance({});
  }
  EXPECT_LE(game.slots(), kMaxPlayers);
}

}  // namespace
}  // namespace platon::game_restore_test
