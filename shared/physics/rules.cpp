#include "shared/physics/rules.h"

namespace platon {

bool Rules::pierce(const Entity&, const LineRef& line) const { return line.warp; }
void Rules::beginContact(Entity&, const LineRef&) {}
void Rules::overContact(Entity&, const LineRef&) {}
void Rules::endContact(Entity&, const LineRef&) {}
void Rules::contact(Entity&, const Contact&) {}
void Rules::touchContact(Entity&, const LineRef&) {}

}  // namespace platon
