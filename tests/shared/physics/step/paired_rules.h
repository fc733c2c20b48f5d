#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <tuple>
#include <utility>

#include "platon/physics/rules.h"

namespace platon {

/// Rules that check that the contacts of every entity, instance and segment begin and end alternately.
class PairedRules : public Rules {
 public:
  /// Entity, instance, part, segment.
  using Contacts = std::set<std::tuple<std::uint32_t, std::uint16_t, std::uint32_t, std::uint32_t>>;

  void beginContact(Entity& entity, const SegmentRef& segment) override {
    require(open.insert(keyOf(entity, segment)).second, "a second beginContact", entity, segment);
  }
  void overContact(Entity& entity, const SegmentRef& segment) override {
    require(open.contains(keyOf(entity, segment)), "overContact without beginContact", entity, segment);
    require(over.insert(keyOf(entity, segment)).second, "a second overContact", entity, segment);
  }
  void endContact(Entity& entity, const SegmentRef& segment) override {
    require(open.erase(keyOf(entity, segment)) == 1, "endContact without beginContact", entity, segment);
  }

  /// Returns and clears the first fault; empty if there is none.
  std::string takeFault() { return std::exchange(fault_, {}); }

  Contacts open;  ///< contacts that have begun
  Contacts over;  ///< those that overContact was called for

 private:
  static Contacts::value_type keyOf(const Entity& entity, const SegmentRef& segment) {
    return {entity.index(), segment.instance, segment.part, segment.index};
  }
  void require(bool holds, const char* what, const Entity& entity, const SegmentRef& segment) {
    if (holds || !fault_.empty()) return;
    fault_ = what + std::string(": entity ") + std::to_string(entity.index()) + ", instance " +
             std::to_string(segment.instance) + ", segment " + std::to_string(segment.part) + ":" +
             std::to_string(segment.index);
  }

  std::string fault_;
};

}  // namespace platon
