#include "tests/fuzz/checked_rules.h"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

namespace platon::fuzz {

void CheckedRules::require(bool holds, const char* what, const SegmentRef& line) {
  if (!holds && fault_.empty()) fault_ = what + std::string(", segment ") + std::to_string(line.index);
}

bool CheckedRules::pierce(const Entity&, const SegmentRef& line) const {
  return line.warp || pierces(line.part, line.index);
}

void CheckedRules::beginContact(Entity& entity, const SegmentRef& line) {
  require(pierce(entity, line), "beginContact with a blocking segment", line);
  if (line.warp || !pairs_) return;
  require(inside_.emplace(entity.index(), line.index).second, "a second beginContact", line);
}

void CheckedRules::endContact(Entity& entity, const SegmentRef& line) {
  require(pierce(entity, line), "endContact with a blocking segment", line);
  if (line.warp || !pairs_) return;
  require(inside_.erase({entity.index(), line.index}) == 1, "endContact without beginContact", line);
}

void CheckedRules::overContact(Entity& entity, const SegmentRef& line) {
  require(pierce(entity, line), "overContact with a blocking segment", line);
  if (line.warp || !pairs_) return;
  require(over_.emplace(entity.index(), line.index).second, "a second overContact", line);
}

void CheckedRules::contact(Entity& entity, const Contact& contact) {
  require(!pierce(entity, contact.segment), "contact with a pierceable segment", contact.segment);
  require(contact.normal != Point(), "contact without a normal", contact.segment);
  require(contact.time >= Fraction{0, 1} && contact.time < Fraction{1, 1}, "contact time not in [0, 1)",
          contact.segment);
}

void CheckedRules::touchContact(Entity& entity, const SegmentRef& line) {
  require(!pierce(entity, line), "touchContact with a pierceable segment", line);
}

std::string CheckedRules::finishTick() {
  std::vector<Overlap> differing;
  std::set_symmetric_difference(inside_.begin(), inside_.end(), over_.begin(), over_.end(),
                                std::back_inserter(differing));
  if (fault_.empty() && pairs_ && !differing.empty()) {
    const auto [entity, line] = differing.front();
    fault_ = "entity " + std::to_string(entity) + ", segment " + std::to_string(line) +
             (over_.contains(differing.front()) ? ": overContact without beginContact" : ": endContact is missing");
  }
  over_.clear();
  return std::exchange(fault_, {});
}

}  // namespace platon::fuzz
