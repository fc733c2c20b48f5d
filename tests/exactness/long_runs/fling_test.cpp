// Entities flung about: shipped levels and random ones, every solid, at any speed. A part of all steps is judged leg by
// leg, the others just run.
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "platon/game/level.h"
#include "platon/game/player.h"
#include "platon/physics/entity.h"
#include "platon/physics/map_part.h"
#include "shared/game/face_area.h"
#include "tests/exactness/judge/run_length.h"
#include "tests/exactness/judge/step_checker.h"
#include "tests/exactness/oracle/random_source.h"
#include "tests/fuzz/fuzz_scene.h"
#include "tests/support/files.h"

namespace platon::long_runs {
namespace {

using oracle::RandomSource;

constexpr std::uint64_t kSeed = 20;
constexpr std::size_t kEntities = 4;
// Judged are the first ticks of each round.
constexpr int kRound = 1024;
constexpr int kJudged = 64;
// Powers of two, subunits a tick. The judge counts every crossing as moves, and takes more than a hundred for endless:
// what it sees crosses a few faces in a tick only.
constexpr std::int64_t kFastest = 24;
constexpr std::int64_t kFastestJudged = 19;

/// A stage without entities, and their shape.
struct Field {
  std::string name;
  World stage;
  Convex shape;
  SolidKind solid;
  std::int32_t faceSize = 0;
};

struct Tally {
  std::int64_t steps = 0;
  std::int64_t judgedSteps = 0;
  std::int64_t judgedLegs = 0;
  std::int64_t crossings = 0;
  std::size_t mostInstances = 0;

  Tally& operator+=(const Tally& other) {
    steps += other.steps;
    judgedSteps += other.judgedSteps;
    judgedLegs += other.judgedLegs;
    crossings += other.crossings;
    mostInstances = std::max(mostInstances, other.mostInstances);
    return *this;
  }
};

/// Some entities on a field.
class Flight {
 public:
  Flight(const Field& field, RandomSource& random)
      : field_(field), random_(random), area_(facePolygon(field.solid, field.faceSize)), world_(field.stage) {
    for (int tries = 0; tries < 200 && count_ < kEntities; ++tries) tryToAdd();
  }

  std::size_t entities() const { return count_; }
  const Tally& tally() const { return tally_; }

  void round() {
    judge::StepChecker checker({field_.stage.geometry(), field_.shape, field_.solid, field_.faceSize});
    for (int tick = 0; tick < kRound; ++tick) {
      fling(tick);
      world_.solve(tick < kJudged ? &checker : nullptr);
      if (tick < kJudged) {
        ASSERT_EQ(checker.finishTick(), "") << field_.name << ", tick " << tick << " of a round, seed " << kSeed;
        count(checker);
      }
    }
    tally_.steps += kRound * static_cast<std::int64_t>(count_);
    tally_.crossings = 0;
    for (const EntityState& entity : world_.entities()) tally_.crossings += entity.crossings;
  }

 private:
  // Home is where the centre is.
  void tryToAdd() {
    const auto part = static_cast<std::uint32_t>(random_.below(field_.stage.geometry().parts.size()));
    const oracle::Vec anywhere = random_.vector(std::int64_t{field_.faceSize} * kSubunitsPerUnit / 2);
    const Point place(static_cast<std::int32_t>(anywhere.x), static_cast<std::int32_t>(anywhere.y));
    const Angle angle(static_cast<std::int32_t>(random_.between(0, Angle::kTurn - 1)));
    const auto shape = field_.shape.turned(angle);
    if (!shape || !area_.contains(place + shape->centre())) return;
    World attempt = world_;
    Entity entity(attempt, field_.shape);
    try {
      MapPart(attempt, part).insert(entity, place, angle);
    } catch (const std::invalid_argument&) {
      return;
    }
    world_ = attempt;
    ++count_;
  }

  // Every speed from a crawl to over the whole solid in one tick; now and then a turn.
  void fling(int tick) {
    for (std::uint32_t i = 0; i < count_; ++i) {
      if (tick != 0 && !random_.oneIn(24)) continue;
      Entity entity(world_, i);
      const std::int64_t fastest = tick < kJudged ? kFastestJudged : kFastest;
      const oracle::Vec velocity =
          random_.vector(std::int64_t{1} << random_.between(4, random_.oneIn(8) ? fastest : 15));
      entity.setVelocity({static_cast<std::int32_t>(velocity.x), static_cast<std::int32_t>(velocity.y)});
      if (random_.oneIn(8)) entity.rotate(static_cast<std::int32_t>(random_.between(-3000, 3000)));
    }
  }

  void count(const judge::StepChecker& checker) {
    for (std::uint32_t i = 0; i < count_; ++i) {
      ++tally_.judgedSteps;
      tally_.judgedLegs += static_cast<std::int64_t>(checker.moves(i));
      tally_.mostInstances = std::max(tally_.mostInstances, checker.instances(i));
    }
  }

  const Field& field_;
  RandomSource& random_;
  FaceArea area_;
  World world_;
  std::size_t count_ = 0;
  Tally tally_;
};

std::vector<Field> fieldsOfShippedLevels() {
  std::vector<Field> fields;
  for (const std::string& file : shippedLevels()) {
    const auto level = loadLevel(readText(file)).level;
    if (level) fields.push_back({file, level->world, playerShape(), level->solid, level->faceSize});
  }
  return fields;
}

// Lines of every kind, also such that are nearly continued or parallel; the ball or another shape.
Field randomField(SolidKind kind, RandomSource& random) {
  for (;;) {
    std::vector<std::uint8_t> bytes(600);
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random.between(0, 255));
    bytes[0] = static_cast<std::uint8_t>(kSolidKinds + static_cast<int>(kind));
    fuzz::ByteSource source(bytes);
    auto scene = fuzz::makeFuzzScene(source);
    if (scene)
      return {std::string(nameOf(kind)), std::move(scene->stage), std::move(scene->shape), kind, scene->faceSize};
  }
}

void fly(const Field& field, RandomSource& random, std::int64_t rounds, Tally& total) {
  Flight flight(field, random);
  for (std::int64_t i = 0; i < rounds && flight.entities() > 0; ++i) ASSERT_NO_FATAL_FAILURE(flight.round());
  total += flight.tally();
}

void report(const Tally& total) {
  std::cout << total.steps << " steps, of these judged " << total.judgedSteps << " with " << total.judgedLegs
            << " legs; " << total.crossings << " crossings, up to " << total.mostInstances << " instances\n";
}

TEST(FlingTest, OverTheShippedLevels) {
  const std::vector<Field> fields = fieldsOfShippedLevels();
  ASSERT_GE(fields.size(), 5u);
  RandomSource random(kSeed);
  Tally total;
  const std::int64_t rounds =
      judge::runLength(1000000, 30000000) / (kRound * static_cast<std::int64_t>(kEntities * fields.size()));
  for (const Field& field : fields) ASSERT_NO_FATAL_FAILURE(fly(field, random, rounds, total));
  report(total);
  EXPECT_GT(total.crossings, total.steps / 200);
}

TEST(FlingTest, OverRandomFields) {
  RandomSource random(kSeed);
  Tally total;
  constexpr std::int64_t roundsOnEach = 4;
  const std::int64_t steps = judge::runLength(3000000, 70000000);
  for (int kind = 0; total.steps < steps; kind = (kind + 1) % kSolidKinds) {
    const Field field = randomField(static_cast<SolidKind>(kind), random);
    ASSERT_NO_FATAL_FAILURE(fly(field, random, roundsOnEach, total));
  }
  report(total);
  EXPECT_GT(total.crossings, total.steps / 200);
}

}  // namespace
}  // namespace platon::long_runs
