// A box is thrown, falls onto a floor and slides along it to a wall.
#include <cstdio>

#include "platon/physics/entity.h"
#include "platon/physics/map_part.h"
#include "platon/physics/world.h"

int main() {
  platon::World world;
  platon::MapPart room(world, 0);
  room.line({0, 0}, {20480, 0});          // the floor, in subunits: 1024 are a unit
  room.line({20480, 0}, {20480, 10240});  // the wall
  room.initialize();

  platon::Entity box(world, platon::Convex({{-512, -512}, {512, -512}, {512, 512}, {-512, 512}}));
  room.insert(box, {1024, 5000}, platon::Angle());
  box.setVelocity({300, 0});  // subunits per tick
  for (int tick = 1; tick <= 80; ++tick) {
    const platon::Point before = box.position();
    box.addVelocity({0, -20});  // gravity
    world.solve();
    box.setVelocity(box.position() - before);  // a body that was stopped has lost that part of its velocity
    if (tick % 16 == 0) std::printf("tick %d: x %d y %d\n", tick, box.position().x, box.position().y);
  }
}

// It prints:
// tick 16: x 5824 y 2280
// tick 32: x 10624 y 512
// tick 48: x 15424 y 512
// tick 64: x 19968 y 512
// tick 80: x 19968 y 512
