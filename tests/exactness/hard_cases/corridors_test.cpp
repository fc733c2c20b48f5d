// Corridors exactly as wide as the shape, and up to four subunits wider.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "platon/exact/integer.h"
#include "shared/physics/tolerances.h"
#include "tests/exactness/hard_cases/checked_world.h"

namespace platon::hard_cases::corridors_test {
namespace {

const char* const kCorridors[] = {"right", "up",           "diagonal",        "three_one",  "seven_three",
                                  "pi",    "nearly_level", "nearly_diagonal", "needle_wide"};

std::vector<Point> positions(const HardScene& scene) {
  std::vector<Point> all;
  for (const EntityState& entity : scene.world.entities()) all.push_back(entity.position);
  return all;
}

// Along a lattice vector nothing is rounded: every entity, even one that touches both walls, moves through the corridor
// and back as if there were no walls.
TEST(CorridorsTest, MovesAlongTheCorridorWithoutContact) {
  for (const char* name : kCorridors) {
    HardScene scene(std::string("corridors/") + name + ".scene");
    const std::vector<Point> start = positions(scene);
    ASSERT_EQ(start.size(), 15u);
    constexpr int ticks = 50;
    for (int tick = 1; tick <= 2 * ticks; ++tick) {
      scene.tick(tick <= ticks ? scene.velocity : -scene.velocity);
      const int away = tick <= ticks ? tick : 2 * ticks - tick;
      for (std::uint32_t i = 0; i < start.size(); ++i) {
        ASSERT_EQ(scene.at(i), start[i] + Point(away * scene.velocity.x, away * scene.velocity.y))
            << name << ", entity " << i << ", tick " << tick;
      }
    }
    EXPECT_TRUE(scene.rules.take().empty()) << name << ": no contact";
  }
}

// In a corridor along an axis, an entity pressed against a wall keeps its speed along the wall.
TEST(CorridorsTest, KeepsItsSpeedWhenPressedAgainstAWall) {
  for (const char* name : {"right", "up"}) {
    for (const std::int32_t press : {1, -1, 3, -350, 700, -70000}) {
      HardScene scene(std::string("corridors/") + name + ".scene");
      const Point across = scene.velocity.x == 0 ? Point(press, 0) : Point(0, press);
      // Enter the corridor first, so that the entity is pressed against walls only.
      for (int tick = 0; tick < 12; ++tick) scene.tick(scene.velocity);
      const std::vector<Point> start = positions(scene);
      for (int tick = 1; tick <= 40; ++tick) {
        const int sign = tick <= 20 ? 1 : -1;
        scene.tick(Point(sign * scene.velocity.x, sign * scene.velocity.y) + across);
        const int away = tick <= 20 ? tick : 40 - tick;
        for (std::uint32_t i = 0; i < start.size(); ++i) {
          const Point moved = scene.at(i) - start[i];
          const Point along(away * scene.velocity.x, away * scene.velocity.y);
          ASSERT_EQ(scene.velocity.x == 0 ? moved.y : moved.x, along.x + along.y) << name << ", press " << press;
          ASSERT_LE(std::abs(scene.velocity.x == 0 ? moved.x : moved.y), 4) << name << ", press " << press;
        }
      }
    }
  }
}

// With a velocity at an angle to the corridor, all invariants hold and no entity passes a wall: its distance from the
// corridor's axis stays within the clearance.
TEST(CorridorsTest, StaysInsideAtASlantedVelocity) {
  for (const char* name : kCorridors) {
    for (const double slant : {0.001, -0.001, 0.1, -0.5}) {
      HardScene scene(std::string("corridors/") + name + ".scene");
      const Point velocity = scene.velocity;
      while (dot(scene.at(), velocity) < 0) scene.tick(velocity);  // until the middle
      const std::vector<Point> start = positions(scene);
      const Point aside(static_cast<std::int32_t>(std::lround(-slant * velocity.y)),
                        static_cast<std::int32_t>(std::lround(slant * velocity.x)));
      const double length = std::hypot(velocity.x, velocity.y);
      for (int tick = 1; tick <= 20; ++tick) {
        const int sign = tick <= 10 ? 1 : -1;
        scene.tick(Point(sign * velocity.x, sign * velocity.y) + aside);
        for (std::uint32_t i = 0; i < start.size(); ++i) {
          const double across = static_cast<double>(cross(velocity, scene.at(i) - start[i])) / length;
          ASSERT_LE(std::abs(across), 4 + 1e-6) << name << ", slant " << slant << ", entity " << i;
        }
      }
    }
  }
}

/// A scene with a gate at x = 0, bounded by two points or by two segments at y = -1000 and y = 1000 + room, and to its
/// left a square of side 2000 with its centre at y = above.
std::string gate(bool points, std::int32_t room, std::int32_t above) {
  const auto post = [&](std::int32_t y) {
    const std::string height = std::to_string(y);
    return "line 0 " + height + (points ? " 0 " : " 900000 ") + height + "\n";
  };
  return "shape -1000 -1000 1000 -1000 1000 1000 -1000 1000\n" + post(1000 + room) + post(-1000) + "entity -1200 " +
         std::to_string(above) + "\n";
}

template <class Visit>
void forEachGate(std::int32_t minRoom, std::int32_t maxRoom, Visit&& visit) {
  for (const bool points : {false, true}) {
    for (std::int32_t room = minRoom; room <= maxRoom; ++room) {
      for (std::int32_t above = -9; above <= 9; ++above) {
        const std::string name = std::string(points ? "points" : "corridor") + ", room " + std::to_string(room) + ", " +
                                 std::to_string(above) + " above";
        SCOPED_TRACE(name);
        HardScene scene(name, gate(points, room, above));
        visit(scene, room, above);
      }
    }
  }
}

// No other segment reaches the ends of a gate, so nothing is nudged through it: one subunit aside, it stops the entity,
// as it stops the ideal one.
TEST(CorridorsTest, AGateIsOpenOnlyWhereTheShapeFits) {
  for (const std::int32_t speed : {7, 300, 7001, 90000}) {
    forEachGate(0, 2, [&](HardScene& scene, std::int32_t room, std::int32_t above) {
      const bool fits = above >= 0 && above <= room;
      const int ticks = 5000 / speed + 2;
      for (int tick = 0; tick < ticks; ++tick) scene.tick({speed, 0});
      EXPECT_EQ(scene.at(), Point(fits ? ticks * speed - 1200 : -1000, above)) << "speed " << speed;
      EXPECT_EQ(scene.rules.take().empty(), fits) << "speed " << speed;
    });
  }
}

// A gate that is narrower than the shape stops it.
TEST(CorridorsTest, IsNotNudgedThroughANarrowGate) {
  for (const Point velocity : {Point(7, 0), Point(300, 0), Point(90000, 0), Point(300, 2), Point(7001, -3)}) {
    forEachGate(-13, -1, [&](HardScene& scene, std::int32_t, std::int32_t) {
      // Too few ticks for the slanted velocities to carry the square around a point.
      for (int tick = 0; tick < 300; ++tick) scene.tick(velocity);
      EXPECT_EQ(scene.at().x, -1000);
    });
  }
}

}  // namespace
}  // namespace platon::hard_cases::corridors_test
