#include "platon/physics/entity_state.h"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

namespace platon::entity_state_test {
namespace {

TEST(EntityStateTest, VelocitiesAreBelowTheLimit) {
  EXPECT_TRUE(isVelocity({kVelocityLimit - 1, 1 - kVelocityLimit}));
  EXPECT_FALSE(isVelocity({kVelocityLimit, 0}));
  EXPECT_FALSE(isVelocity({-kVelocityLimit, 0}));
  EXPECT_FALSE(isVelocity({0, kVelocityLimit}));
  EXPECT_FALSE(isVelocity({0, -kVelocityLimit}));
}

TEST(EntityStateTest, AllocatesConsecutiveIds) {
  std::uint16_t next = 7;
  const auto unused = [](std::uint16_t) { return false; };
  EXPECT_EQ(allocateId(next, unused), 7);
  EXPECT_EQ(allocateId(next, unused), 8);
  EXPECT_EQ(next, 9);
}

TEST(EntityStateTest, AllocationSkipsIdsInUse) {
  const std::set<std::uint16_t> used{7, 8, 10};
  std::uint16_t next = 7;
  EXPECT_EQ(allocateId(next, [&](std::uint16_t id) { return used.contains(id); }), 9);
  EXPECT_EQ(allocateId(next, [&](std::uint16_t id) { return used.contains(id); }), 11);
}

TEST(EntityStateTest, AllocationWrapsAroundWithoutTheReservedId) {
  std::uint16_t next = 65534;
  const auto unused = [](std::uint16_t) { return false; };
  EXPECT_EQ(allocateId(next, unused), 65534);
  EXPECT_EQ(allocateId(next, unused), 0) << "65535 is kNoParent";
  next = 65534;
  EXPECT_EQ(allocateId(next, [](std::uint16_t id) { return id >= 65530 || id < 3; }), 3);
}

TEST(EntityStateTest, AnInstanceMovesWithHomeInItsOwnFrame) {
  EntityState entity;
  entity.position = {107, 197};
  entity.angle = Angle::degrees(30);
  InstanceState instance;
  instance.angle = Angle::degrees(120);
  instance.homeAnchor = {100, 200};
  instance.anchor = {-5000, 70};
  EXPECT_EQ(positionOf(entity, instance), Point(-4997, 77));
  entity.position = instance.homeAnchor;
  EXPECT_EQ(positionOf(entity, instance), instance.anchor);
}

TEST(EntityStateTest, VisitsFieldsInTheirHashedOrder) {
  std::vector<std::string> names;
  const auto note = [&](const char* name, const auto&) { names.push_back(name); };
  const EntityState entity;
  EntityState::visit(entity, note);
  EXPECT_EQ(names, (std::vector<std::string>{"shape", "part", "position", "velocity", "remainder", "heading", "angle",
                                             "turn", "id", "nextId", "instances", "inserted", "fresh", "crossings"}));
  names.clear();
  const InstanceState instance;
  InstanceState::visit(instance, note);
  EXPECT_EQ(names,
            (std::vector<std::string>{"part", "angle", "homeAnchor", "anchor", "id", "parent", "warp", "fresh"}));
}

}  // namespace
}  // namespace platon::entity_state_test
