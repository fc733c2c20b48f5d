// Catches what the library throws, and derives from a class of the library, which needs the RTTI of that class. Exits 0
// if the exception came.
#include <stdexcept>

#include "platon/physics/convex.h"
#include "platon/physics/entity.h"
#include "platon/physics/rules.h"
#include "platon/physics/world.h"

struct OwnRules : platon::Rules {};

int main() {
  platon::World world;
  OwnRules rules;
  world.setRules(rules);
  try {
    platon::Entity clockwise(world, platon::Convex({{0, 0}, {0, 2}, {2, 2}}));
  } catch (const std::invalid_argument&) {
    return dynamic_cast<platon::Rules*>(&rules) == &rules ? 0 : 2;
  }
  return 1;
}
