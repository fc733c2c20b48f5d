#include "client/netcode/prediction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <memory>
#include <random>
#include <vector>

#include "client/bot/button_presser.h"
#include "tests/support/test_levels.h"

namespace platon::prediction_test {
namespace {

using std::chrono::milliseconds;

constexpr std::uint32_t kLocal = 1;
constexpr Time kNow = std::chrono::seconds(9);

using Inputs = std::vector<Input>;

Input present(std::uint8_t buttons) { return {static_cast<std::uint8_t>(buttons | Input::kPresent)}; }

// The expected prediction: the confirmed game advanced with the local inputs and the held inputs of the others.
Game expectedPrediction(const Prediction& prediction) {
  Game game = prediction.confirmed();
  for (std::uint32_t tick = prediction.confirmedTicks(); tick < prediction.predictedTicks(); ++tick) {
    Inputs inputs(prediction.held().begin(), prediction.held().end());
    inputs.resize(std::max<std::size_t>(inputs.size(), kLocal + 1));
    inputs[kLocal] = prediction.localInputs(tick)[0];
    game.advance(inputs);
  }
  return game;
}

TEST(Prediction, EqualsTheConfirmedGameAdvancedWithLocalInputs) {
  std::mt19937 random(5);
  ButtonPresser local(1), other(2);
  Game server(flatLevel());
  Prediction prediction(server, {kLocal});
  std::uint32_t ahead = 0;
  for (int step = 0; step < 1500; ++step) {
    if (prediction.predictedTicks() - prediction.confirmedTicks() < ahead + 1) {
      ASSERT_TRUE(prediction.mayPredict());
      prediction.predict({present(local.next().buttons)});
    }
    if (random() % 40 == 0) ahead = static_cast<std::uint32_t>(random() % 30);
    for (auto batch = random() % 3; batch > 0; --batch) {
      if (prediction.confirmedTicks() >= prediction.predictedTicks()) break;
      // Now and then the server decides another local input, as for one that arrived too late.
      const Input decided = random() % 50 == 0 ? present(0) : prediction.localInputs(prediction.confirmedTicks())[0];
      const Inputs inputs = {present(other.next().buttons), decided};
      server.advance(inputs);
      prediction.confirm(inputs);
    }
    prediction.reconcile(kNow);
    ASSERT_EQ(prediction.confirmed().hash(), server.hash()) << "step " << step;
    ASSERT_EQ(prediction.predicted().hash(), expectedPrediction(prediction).hash()) << "step " << step;
  }
  EXPECT_GT(prediction.statistics().corrections, 0u);
  EXPECT_GT(prediction.statistics().missedInputs, 0u);
}

// Companions come, leave, and come back in other slots; inputs are late now and then.
TEST(Prediction, EqualsTheConfirmedGameWithTheInputsOfAllLocalPlayers) {
  std::mt19937 random(6);
  std::array<ButtonPresser, kMaxLocalPlayers> local{ButtonPresser(1), ButtonPresser(2), ButtonPresser(3),
                                                    ButtonPresser(4)};
  ButtonPresser other(5);
  Game server(flatLevel());
  Prediction prediction(server, {kLocal});
  std::uint32_t corrections = 0;
  for (int step = 0; step < 3000; ++step) {
    if (random() % 100 == 0) {
      SlotsByLocal slots{kLocal};
      for (std::uint32_t i = 1; i < kMaxLocalPlayers; ++i)
        if (random() % 2 == 0) slots[i] = 2 + 3 * (random() % 2) + (i - 1);
      prediction.setSlots(slots);
      prediction.reconcile(kNow);
      corrections = prediction.statistics().corrections;
    }
    const SlotsByLocal slots = prediction.slots();
    if (prediction.predictedTicks() - prediction.confirmedTicks() < 12) {
      InputsByLocal inputs;
      for (std::size_t i = 0; i < inputs.size(); ++i)
        if (slots[i]) inputs[i] = present(local[i].next().buttons);
      prediction.predict(inputs);
    } else {
      Inputs inputs(8);
      inputs[0] = present(other.next().buttons);
      const InputsByLocal& predicted = prediction.localInputs(prediction.confirmedTicks());
      for (std::size_t i = 0; i < predicted.size(); ++i)
        if (slots[i] && predicted[i].has(Input::kPresent))
          inputs[*slots[i]] = random() % 50 == 0 ? present(0) : predicted[i];
      server.advance(inputs);
      prediction.confirm(inputs);
      prediction.reconcile(kNow);
    }
    Game expected = prediction.confirmed();
    for (std::uint32_t tick = prediction.confirmedTicks(); tick < prediction.predictedTicks(); ++tick) {
      Inputs inputs(prediction.held().begin(), prediction.held().end());
      for (std::size_t i = 0; i < slots.size(); ++i)
        if (slots[i] && prediction.localInputs(tick)[i].has(Input::kPresent))
          inputs[*slots[i]] = prediction.localInputs(tick)[i];
      expected.advance(inputs);
    }
    ASSERT_EQ(prediction.confirmed().hash(), server.hash()) << "step " << step;
    ASSERT_EQ(prediction.predicted().hash(), expected.hash()) << "step " << step;
  }
  EXPECT_GT(corrections, 0U);
  EXPECT_GT(prediction.statistics().missedInputs, 0U);
}

TEST(Prediction, WhoTakesALocalNumberOverHasNoInputsOfTheOneBefore) {
  Prediction prediction(Game(flatLevel()), {0, 1});
  for (int tick = 0; tick < 9; ++tick) prediction.predict({present(0), present(Input::kRight)});
  prediction.setSlots({0, 2});
  prediction.reconcile(kNow);
  EXPECT_EQ(prediction.predictedTicks(), 9U);
  EXPECT_EQ(prediction.localInputs(3)[1], Input());
  EXPECT_TRUE(prediction.predicted().slots() < 2 || prediction.predicted().player(1).present == 0);
  EXPECT_TRUE(prediction.predicted().slots() < 3 || prediction.predicted().player(2).present == 0);
}

TEST(Prediction, EachLocalPlayerHasItsOwnCorrections) {
  Prediction prediction(Game(flatLevel()), {0, 1});
  const InputsByLocal resting{present(0), present(0)};
  for (int tick = 0; tick < 9; ++tick) prediction.predict(resting);
  prediction.confirm(Inputs{present(0), present(Input::kRight)});
  prediction.confirm(Inputs{present(0), present(Input::kRight)});
  prediction.reconcile(kNow);
  EXPECT_EQ(prediction.statistics().missedInputs, 1U) << "in the first tick, nobody is present before it";
  EXPECT_EQ(prediction.smoothing(0, kNow), Point());
  EXPECT_NE(prediction.smoothing(1, kNow), Point());
}

TEST(Prediction, NeedsNoCorrectionWhenInputsArriveInTime) {
  ButtonPresser local(3), other(4);
  Prediction prediction(Game(flatLevel()), {kLocal});
  for (int tick = 0; tick < 600; ++tick) {
    prediction.predict({present(local.next().buttons)});
    if (tick < 12) continue;
    const Inputs inputs = {present(other.next().buttons), prediction.localInputs(prediction.confirmedTicks())[0]};
    prediction.confirm(inputs);
    prediction.reconcile(kNow);
  }
  EXPECT_EQ(prediction.statistics().corrections, 0u);
  EXPECT_EQ(prediction.statistics().missedInputs, 0u);
  EXPECT_EQ(prediction.statistics().confirmedTicks, 588u);
  EXPECT_EQ(prediction.smoothing(0, kNow), Point());
}

// The law: each tick of a game counts once per player, and the replays stay within a limit.
TEST(Prediction, CountsItsWork) {
  Prediction prediction(Game(endlessLevel()), {kLocal});
  for (int tick = 0; tick < 10; ++tick) prediction.predict({present(0)});
  EXPECT_EQ(prediction.work(), 10u);
  prediction.confirm(Inputs{present(Input::kLeft), present(0), present(0)});
  EXPECT_EQ(prediction.work(), 10u + 3);
  prediction.reconcile(kNow);
  EXPECT_EQ(prediction.work(), 10u + 3 + 9 * 3);
  prediction.reconcile(kNow);
  EXPECT_EQ(prediction.work(), 10u + 3 + 9 * 3);
}

TEST(Prediction, PredictsFewerTicksWithManyPlayers) {
  Prediction prediction(Game(endlessLevel()), {kLocal});
  while (prediction.mayPredict()) prediction.predict({present(0)});
  EXPECT_EQ(prediction.predictedTicks(), Prediction::kMaxAhead);
  for (const std::uint32_t players : {kMaxPlayers, 100u, 64u}) {
    prediction.confirm(Inputs(players, present(0)));
    prediction.reconcile(kNow);
    while (prediction.mayPredict()) prediction.predict({present(0)});
    EXPECT_EQ(prediction.predictedTicks() - prediction.confirmedTicks(), Prediction::kMaxWorkAhead / players);
  }
}

// A level whose start is rotated by a quarter turn, so that the player falls in the direction of x.
std::shared_ptr<const Level> rotatedLevel() {
  return loadLevel("HEXAHEDRON\n0 150 0 90\n1 0 0\n480\n%\n200 -240 200 240\n%\n%\n%\n%\n%\n").level;
}

// Predicts ten ticks of running right; the server decides that nothing was pressed in the first one.
Prediction corrected(const std::shared_ptr<const Level>& level = flatLevel()) {
  Prediction prediction(Game(level), {kLocal});
  const Inputs standing = {Input{}, present(0)};
  for (int tick = 0; tick < 60; ++tick) prediction.confirm(standing);
  prediction.reconcile(kNow);
  for (int tick = 0; tick < 10; ++tick) prediction.predict({present(Input::kRight)});
  prediction.confirm(standing);
  return prediction;
}

TEST(Prediction, MeasuresAndSmoothsACorrection) {
  Prediction prediction = corrected();
  const Point before = prediction.predicted().world().entities()[kLocal].position;
  prediction.reconcile(kNow);
  const Point after = prediction.predicted().world().entities()[kLocal].position;
  ASSERT_NE(before, after);
  EXPECT_EQ(before.y, after.y);
  EXPECT_EQ(prediction.statistics().corrections, 1u);
  EXPECT_EQ(prediction.statistics().missedInputs, 1u);
  EXPECT_EQ(prediction.statistics().maxSubunits, before.x - after.x);
  // The drawn position does not jump, and equals the prediction after 100 ms.
  EXPECT_EQ(after + prediction.smoothing(0, kNow), before);
  const Point half = prediction.smoothing(0, kNow + ErrorSmoothing::kDuration / 2);
  EXPECT_NEAR(half.x, (before.x - after.x) / 2, 1);
  EXPECT_EQ(prediction.smoothing(0, kNow + ErrorSmoothing::kDuration), Point());
}

TEST(Prediction, ACorrectionIsInTheFrameOfARotatedPlayer) {
  Prediction prediction = corrected(rotatedLevel());
  const Point before = prediction.predicted().world().entities()[kLocal].position;
  prediction.reconcile(kNow);
  const Point after = prediction.predicted().world().entities()[kLocal].position;
  EXPECT_EQ(before.x, after.x);
  ASSERT_GT(before.y, after.y);  // the player's right
  EXPECT_EQ(prediction.smoothing(0, kNow), Point(before.y - after.y, 0));
}

TEST(Prediction, StopsFourSecondsAhead) {
  Prediction prediction(Game(flatLevel()), {kLocal});
  for (std::uint32_t tick = 0; tick < Prediction::kMaxAhead; ++tick) {
    ASSERT_TRUE(prediction.mayPredict());
    prediction.predict({present(0)});
  }
  EXPECT_FALSE(prediction.mayPredict());
  EXPECT_EQ(prediction.predictedTicks(), Prediction::kMaxAhead);
}

TEST(Prediction, FollowsAServerThatIsAhead) {
  Prediction prediction(Game(flatLevel()), {kLocal});
  const Inputs inputs = {present(Input::kLeft), present(Input::kRight)};
  for (int tick = 0; tick < 50; ++tick) prediction.confirm(inputs);
  prediction.reconcile(kNow);
  EXPECT_EQ(prediction.predictedTicks(), 50u);
  EXPECT_EQ(prediction.predicted().hash(), prediction.confirmed().hash());
}

TEST(Prediction, RestoresTheServersState) {
  Game server(flatLevel());
  const Inputs inputs = {present(Input::kRight), present(Input::kRight), present(Input::kJump)};
  for (int tick = 0; tick < 100; ++tick) server.advance(inputs);
  Prediction prediction(Game(flatLevel()), {kLocal});
  for (int tick = 0; tick < 105; ++tick) prediction.predict({present(0)});
  ASSERT_TRUE(prediction.restore(server.save(), 100, inputs));
  prediction.reconcile(kNow);
  EXPECT_EQ(prediction.confirmedTicks(), 100u);
  EXPECT_EQ(prediction.predictedTicks(), 105u);
  EXPECT_EQ(prediction.confirmed().hash(), server.hash());
  EXPECT_EQ(prediction.predicted().hash(), expectedPrediction(prediction).hash());
}

TEST(Prediction, RefusesAnInvalidState) {
  Prediction prediction(Game(flatLevel()), {kLocal});
  const std::uint64_t hash = prediction.confirmed().hash();
  const std::vector<std::uint8_t> invalid(17, 0xee);
  EXPECT_FALSE(prediction.restore(invalid, 5, {}));
  EXPECT_EQ(prediction.confirmedTicks(), 0u);
  EXPECT_EQ(prediction.confirmed().hash(), hash);
}

// The tick of a full state comes from the server, so it may have any value.
TEST(Prediction, StopsAtTheLargestTick) {
  Game server(flatLevel());
  Prediction prediction(server, {kLocal});
  for (int tick = 0; tick < 5; ++tick) prediction.predict({present(0)});
  ASSERT_TRUE(prediction.restore(server.save(), UINT32_MAX - 3, {}));
  prediction.reconcile(kNow);
  EXPECT_EQ(prediction.predictedTicks(), UINT32_MAX - 3);
  for (int tick = 0; tick < 3; ++tick) {
    ASSERT_TRUE(prediction.mayPredict());
    prediction.predict({present(0)});
  }
  EXPECT_FALSE(prediction.mayPredict());
  ASSERT_TRUE(prediction.restore(server.save(), UINT32_MAX - 3, {}));
  prediction.reconcile(kNow);
  EXPECT_EQ(prediction.predictedTicks(), UINT32_MAX);
}

constexpr Time kStart = std::chrono::hours(2);

struct Correction {
  Point offset;
  Time at;
};

// Sum of all fading corrections: each fades linearly within 100 ms and is rounded towards zero.
Point expected(const std::vector<Correction>& corrections, Time now) {
  Point sum;
  for (const Correction& correction : corrections) {
    const std::int64_t left = 100'000 - (now - correction.at).count();
    if (left <= 0 || now < correction.at) continue;
    sum += Point(static_cast<std::int32_t>(correction.offset.x * left / 100'000),
                 static_cast<std::int32_t>(correction.offset.y * left / 100'000));
  }
  return sum;
}

// `count` corrections in various directions, evenly spread over 100 ms.
std::vector<Correction> series(int count) {
  std::vector<Correction> corrections;
  for (int i = 0; i < count; ++i) {
    corrections.push_back(
        {Point((i * 7 % 5 - 2) * 9000, (i * 3 % 4 - 1) * 7000), kStart + milliseconds(100) * i / count});
  }
  return corrections;
}

TEST(ErrorSmoothing, IsZeroAtFirst) { EXPECT_EQ(ErrorSmoothing().at(kStart), Point()); }

TEST(ErrorSmoothing, FadesMonotonicallyToZero) {
  ErrorSmoothing smoothing;
  smoothing.add(Point(1000, -500), kStart);
  EXPECT_EQ(smoothing.at(kStart), Point(1000, -500));
  Point last(1000, -500);
  for (int ms = 1; ms <= 150; ++ms) {
    const Point now = smoothing.at(kStart + milliseconds(ms));
    EXPECT_LE(now.x, last.x);
    EXPECT_GE(now.y, last.y);
    last = now;
  }
  EXPECT_EQ(smoothing.at(kStart + milliseconds(50)), Point(500, -250));
  EXPECT_EQ(smoothing.at(kStart + milliseconds(100)), Point());
}

TEST(ErrorSmoothing, ACorrectionLastsAHundredMilliseconds) {
  ErrorSmoothing smoothing;
  smoothing.add(Point(1000, 0), kStart);
  smoothing.add(Point(0, 300), kStart + milliseconds(50));
  EXPECT_EQ(smoothing.at(kStart + milliseconds(50)), Point(500, 300));
  EXPECT_EQ(smoothing.at(kStart + milliseconds(75)), Point(250, 225));
  EXPECT_EQ(smoothing.at(kStart + milliseconds(100)), Point(0, 150));
  EXPECT_EQ(smoothing.at(kStart + milliseconds(150)), Point());
}

TEST(ErrorSmoothing, CorrectionsFadeIndependently) {
  for (const int count : {2, 10, static_cast<int>(ErrorSmoothing::kMaxCorrections)}) {
    ErrorSmoothing smoothing;
    const std::vector<Correction> corrections = series(count);
    auto next = corrections.begin();
    for (Time now = kStart; now <= kStart + milliseconds(210); now += std::chrono::microseconds(250)) {
      for (; next != corrections.end() && next->at <= now; ++next) smoothing.add(next->offset, next->at);
      ASSERT_EQ(smoothing.at(now), expected(corrections, now)) << count << " corrections, " << (now - kStart).count();
    }
    EXPECT_EQ(smoothing.at(kStart + milliseconds(200)), Point());
  }
}

// The prediction jumps by -offset at the same moment, so the drawn position, which is their sum, does not jump.
TEST(ErrorSmoothing, TheDrawnPositionDoesNotJump) {
  for (const int count : {1, 10, 32}) {
    ErrorSmoothing smoothing;
    const std::vector<Correction> corrections = series(count);
    Point prediction;
    Point last;
    auto next = corrections.begin();
    for (int ms = 0; ms <= 210; ++ms) {
      const Time now = kStart + milliseconds(ms);
      std::int64_t fading = 0;
      for (const Correction& one : corrections) {
        const bool fades = one.at <= now && now - one.at <= milliseconds(101);
        fading += fades ? std::abs(one.offset.x) + std::abs(one.offset.y) : 0;
      }
      for (; next != corrections.end() && next->at <= now; ++next) {
        const Point before = smoothing.at(next->at);
        smoothing.add(next->offset, next->at);
        prediction -= next->offset;
        const Point jump = smoothing.at(next->at) - next->offset - before;
        EXPECT_LE(std::abs(jump.x) + std::abs(jump.y), 2) << count << " corrections, " << ms << " ms";
      }
      const Point drawn = prediction + smoothing.at(now);
      const std::int64_t moved = std::abs(drawn.x - last.x) + std::abs(drawn.y - last.y);
      EXPECT_LE(moved, fading / 100 + 2 * count) << count << " corrections, " << ms << " ms";
      last = drawn;
    }
  }
}

TEST(ErrorSmoothing, DropsTheOldestCorrectionWhenFull) {
  ErrorSmoothing smoothing;
  smoothing.add(Point(1000000, 0), kStart);
  for (std::size_t i = 1; i < ErrorSmoothing::kMaxCorrections; ++i) smoothing.add(Point(0, 1), kStart);
  EXPECT_EQ(smoothing.at(kStart), Point(1000000, 31));
  smoothing.add(Point(0, 1), kStart);
  EXPECT_EQ(smoothing.at(kStart), Point(0, 32));
}

TEST(ErrorSmoothing, ClearRemovesAllCorrections) {
  ErrorSmoothing smoothing;
  smoothing.add(Point(1000, 0), kStart);
  smoothing.clear();
  EXPECT_EQ(smoothing.at(kStart), Point());
}

}  // namespace
}  // namespace platon::prediction_test
