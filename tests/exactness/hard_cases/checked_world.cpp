#include "tests/exactness/hard_cases/checked_world.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <utility>

#include "levels/tool/level_file.h"
#include "platon/game/diagnostics.h"
#include "platon/game/player.h"
#include "platon/physics/map_part.h"

namespace platon::hard_cases {
namespace {

std::shared_ptr<const Level> readLevel(const std::string& name) {
  LevelResult result = loadLevel(readSceneFile(name));
  for (const Diagnostic& found : result.diagnostics) throw std::runtime_error(format(name, found));
  return result.level;
}

}  // namespace

std::string readSceneFile(const std::string& name) {
  std::string fault;
  const auto text = readInputFile("tests/exactness/hard_cases/scenes/" + name, kMaxLevelBytes, fault);
  if (!text) throw std::runtime_error(fault);
  return *text;
}

CheckedWorld::CheckedWorld(std::string name, World initial, Options options)
    : world(std::move(initial)),
      shape(std::move(options.shape)),
      rules(std::move(options.rules)),
      checker({world.geometry(), shape, options.solid, options.faceSize,
               [this](std::uint32_t part, std::uint32_t line) {
                 return rules.pierceable.contains({part, line});
               }}),
      name_(std::move(name)) {}

void CheckedWorld::tick(Point velocity) {
  for (std::uint32_t i = 0; i < world.entities().size(); ++i) entity(i).setVelocity(velocity);
  tick();
}

void CheckedWorld::tick() {
  rules.contacts.clear();
  world.setRules(rules);
  world.solve(&checker);
  const std::string fault = checker.finishTick();
  if (fault.empty() || !invariantsHold_) return;
  invariantsHold_ = false;
  ADD_FAILURE() << name_ << ": " << fault;
}

int CheckedWorld::ticksUntilRest(Point velocity, int maxTicks) {
  for (int ticks = 0; ticks < maxTicks; ++ticks) {
    const WorldState before = world.save();
    tick(velocity);
    bool moved = false;
    for (std::size_t i = 0; i < before.entities.size(); ++i) {
      moved = moved || before.entities[i].position != world.entities()[i].position;
    }
    if (!moved) return ticks;
  }
  return maxTicks;
}

HardScene::HardScene(const std::string& name, std::string_view text) : HardScene(name, sim::loadScene(name, text)) {}

HardScene::HardScene(const std::string& name, sim::Scene scene)
    : CheckedWorld(name, std::move(scene.world), {.shape = scene.shape}), velocity(scene.velocity) {}

HardLevel::HardLevel(const std::string& name, RecordedRules initialRules)
    : HardLevel(name, readLevel(name), std::move(initialRules)) {}

HardLevel::HardLevel(const std::string& name, std::shared_ptr<const Level> loaded, RecordedRules initialRules)
    : CheckedWorld(name, loaded->world, {playerShape(), loaded->solid, loaded->faceSize, std::move(initialRules)}),
      level(std::move(loaded)) {}

bool HardLevel::place(std::uint32_t face, Point position, Angle angle) {
  world = level->world;
  Entity ball(world, shape);
  try {
    MapPart(world, face).insert(ball, position, angle);
  } catch (const std::invalid_argument&) {
    return false;
  }
  return true;
}

void HardLevel::push(Point velocity) { tick(rotate(velocity, entity().rotation())); }

}  // namespace platon::hard_cases
