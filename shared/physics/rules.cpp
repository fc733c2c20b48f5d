#include "platon/physics/rules.h"

namespace platon {

bool Rules::pierce(const Entity&, const SegmentRef& segment) const { return segment.warp; }
void Rules::beginContact(Entity&, const SegmentRef&) {}
void Rules::overContact(Entity&, const SegmentRef&) {}
void Rules::endContact(Entity&, const SegmentRef&) {}
void Rules::contact(Entity&, const Contact&) {}
void Rules::touchContact(Entity&, const SegmentRef&) {}

}  // namespace platon
