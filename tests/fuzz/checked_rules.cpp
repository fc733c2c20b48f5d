#include "tests/fuzz/checked_rules.h"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

namespace platon::fuzz {

void CheckedRules::require(bool holds, const char* what, const SegmentRef& segment) {
  if (!holds && fault_.empty()) fault_ = what + std::string(", segment ") + std::to_string(segment.index);
}

bool CheckedRules::pierce(const Entity&, const SegmentRef& segment) const {
  return segment.warp || pierces(segment.part, segment.index);
}

void CheckedRules::beginContact(Entity& entity, const SegmentRef& segment) {
  require(pierce(entity, segment), "beginContact with a blocking segment", segment);
  require(inside_.insert(overlapOf(entity, segment)).second, "a second beginContact", segment);
}

void CheckedRules::endContact(Entity& entity, const SegmentRef& segment) {
  require(pierce(entity, segment), "endContact with a blocking segment", segment);
  require(inside_.erase(overlapOf(entity, segment)) == 1, "endContact without beginContact", segment);
}

void CheckedRules::overContact(Entity& entity, const SegmentRef& segment) {
  require(pierce(entity, segment), "overContact with a blocking segment", segment);
  require(over_.insert(overlapOf(entity, segment)).second, "a second overContact", segment);
}

void CheckedRules::contact(Entity& entity, const Contact& contact) {
  require(!pierce(entity, contact.segment), "contact with a pierceable segment", contact.segment);
  require(contact.normal != Point(), "contact without a normal", contact.segment);
  require(contact.time >= Fraction{0, 1} && contact.time < Fraction{1, 1}, "contact time not in [0, 1)",
          contact.segment);
}

void CheckedRules::touchContact(Entity& entity, const SegmentRef& segment) {
  require(!pierce(entity, segment), "touchContact with a pierceable segment", segment);
}

std::string CheckedRules::finishTick() {
  std::vector<Overlap> differing;
  std::set_symmetric_difference(inside_.begin(), inside_.end(), over_.begin(), over_.end(),
                                std::back_inserter(differing));
  if (fault_.empty() && !differing.empty()) {
    const auto [entity, instance, part, segment] = differing.front();
    fault_ = "entity " + std::to_string(entity) + ", instance " + std::to_string(instance) + ", segment " +
             std::to_string(part) + ":" + std::to_string(segment) +
             (over_.contains(differing.front()) ? ": overContact without beginContact" : ": endContact is missing");
  }
  over_.clear();
  return std::exchange(fault_, {});
}

}  // namespace platon::fuzz
