#include "platon/physics/rules.h"

namespace platon {

bool Rules::pierce(const Entity&, const SegmentRef& segment) const { return segment.warp; }
bool Rules::mayPierce(std::uint32_t, std::uint32_t) const { return true; }
void Rules::beginContact(Entity&, const SegmentRef&) {}
void Rules::overContact(Entity&, const SegmentRef&) {}
void Rules::endContact(Entity&, const SegmentRef&) {}
void Rules::contact(Entity&, const Contact&) {}
void Rules::touchContact(Entity&, const SegmentRef&) {}

}  // namespace platon
