// Entities at random velocities on a level of each solid and on random fields. The oracle checks every leg of the
// first ticks of each round.
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
#include "tests/exactness/oracle/random_source.h"
#include "tests/exactness/step_check/run_length.h"
#include "tests/exactness/step_check/step_checker.h"
#include "tests/fuzz/fuzz_scene.h"
#include "tests/support/files.h"

namespace platon::long_runs::fling_test {
namespace {

using oracle::RandomSource;

constexpr std::uint64_t kSeed = 20;
constexpr std::size_t kEntities = 4;
constexpr int kRound = 1024;  // ticks of a round
constexpr int kChecked = 64;  // ticks of a round that are checked
// Largest velocities in subunits per tick, as powers of two. The oracle allows at most 100 moves per step, and every
// crossing needs some, so checked entities may cross only a few faces per tick.
constexpr std::int64_t kFastest = 24;
constexpr std::int64_t kFastestChecked = 19;

/// A stage without entities, and the shape of the entities to insert.
struct Field {
  std::string name;
  World stage;
  Convex shape;
  SolidKind solid;
  std::int32_t faceSize = 0;
};

struct Tally {
  std::int64_t steps = 0;
  std::int64_t checkedSteps = 0;
  std::int64_t checkedLegs = 0;
  std::int64_t crossings = 0;
  std::size_t maxInstances = 0;

  Tally& operator+=(const Tally& other) {
    steps += other.steps;
    checkedSteps += other.checkedSteps;
    checkedLegs += other.checkedLegs;
    crossings += other.crossings;
    maxInstances = std::max(maxInstances, other.maxInstances);
    return *this;
  }
};

/// Up to four entities on a field.
class Flight {
 public:
  Flight(const Field& field, RandomSource& random)
      : field_(field), random_(random), area_(facePolygon(field.solid, field.faceSize)), world_(field.stage) {
    for (int tries = 0; tries < 200 && count_ < kEntities; ++tries) tryToAdd();
  }

  std::size_t entities() const { return count_; }
  const Tally& tally() const { return tally_; }

  void round() {
    step_check::StepChecker checker({field_.stage.geometry(), field_.shape, field_.solid, field_.faceSize});
    for (int tick = 0; tick < kRound; ++tick) {
      fling(tick);
      world_.solve(tick < kChecked ? &checker : nullptr);
      if (tick < kChecked) {
        ASSERT_EQ(checker.finishTick(), "") << field_.name << ", tick " << tick << " of a round, seed " << kSeed;
        count(checker);
      }
    }
    tally_.steps += kRound * static_cast<std::int64_t>(count_);
    tally_.crossings = 0;
    for (const EntityState& entity : world_.entities()) tally_.crossings += entity.crossings;
  }

 private:
  // Inserts an entity at a random place, with its centre in the part, unless it overlaps a segment there.
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

  // Sets random velocities, from 2^4 subunits per tick to several times around the solid, and sometimes a rotation.
  void fling(int tick) {
    for (std::uint32_t i = 0; i < count_; ++i) {
      if (tick != 0 && !random_.oneIn(24)) continue;
      Entity entity(world_, i);
      const std::int64_t fastest = tick < kChecked ? kFastestChecked : kFastest;
      const oracle::Vec velocity =
          random_.vector(std::int64_t{1} << random_.between(4, random_.oneIn(8) ? fastest : 15));
      entity.setVelocity({static_cast<std::int32_t>(velocity.x), static_cast<std::int32_t>(velocity.y)});
      if (random_.oneIn(8)) entity.rotate(static_cast<std::int32_t>(random_.between(-3000, 3000)));
    }
  }

  void count(const step_check::StepChecker& checker) {
    for (std::uint32_t i = 0; i < count_; ++i) {
      ++tally_.checkedSteps;
      tally_.checkedLegs += static_cast<std::int64_t>(checker.moves(i));
      tally_.maxInstances = std::max(tally_.maxInstances, checker.instances(i));
    }
  }

  const Field& field_;
  RandomSource& random_;
  FaceArea area_;
  World world_;
  std::size_t count_ = 0;
  Tally tally_;
};

std::vector<Field> fieldsOfSolidLevels() {
  std::vector<Field> fields;
  for (const std::string& file : solidLevels()) {
    const auto level = loadLevel(readText(file)).level;
    if (level) fields.push_back({file, level->world, playerShape(), level->solid, level->faceSize});
  }
  return fields;
}

// Random segments, some nearly continued or parallel; the ball or another shape.
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
  std::cout << total.steps << " steps, of which " << total.checkedSteps << " checked with " << total.checkedLegs
            << " legs; " << total.crossings << " crossings, up to " << total.maxInstances << " instances\n";
}

TEST(FlingTest, InvariantsHoldOnALevelOfEachSolid) {
  const std::vector<Field> fields = fieldsOfSolidLevels();
  ASSERT_GE(fields.size(), 5u);
  RandomSource random(kSeed);
  Tally total;
  const std::int64_t rounds =
      step_check::runLength(1000000, 30000000) / (kRound * static_cast<std::int64_t>(kEntities * fields.size()));
  for (const Field& field : fields) ASSERT_NO_FATAL_FAILURE(fly(field, random, rounds, total));
  report(total);
  EXPECT_GT(total.crossings, total.steps / 200);
}

TEST(FlingTest, InvariantsHoldOnRandomFields) {
  RandomSource random(kSeed);
  Tally total;
  constexpr std::int64_t roundsOnEach = 4;
  const std::int64_t steps = step_check::runLength(3000000, 70000000);
  for (int kind = 0; total.steps < steps; kind = (kind + 1) % kSolidKinds) {
    const Field field = randomField(static_cast<SolidKind>(kind), random);
    ASSERT_NO_FATAL_FAILURE(fly(field, random, roundsOnEach, total));
  }
  report(total);
  EXPECT_GT(total.crossings, total.steps / 200);
}

}  // namespace
}  // namespace platon::long_runs::fling_test
