#pragma once

#include "platon/physics/map_geometry.h"
#include "platon/physics/rules.h"

namespace platon {

/// Passes everything on to the rules of a world, with the tags of the segments: a step does not know them, and so they
/// cost nothing where there are none. `geometry` and the rules must outlive it.
class TaggedRules final : public Rules {
 public:
  TaggedRules(Rules& rules, const Geometry& geometry) : rules_(rules), geometry_(geometry) {}

  /// What a step must ask: this object, or the rules themselves where no segment has a tag.
  Rules& outermost() { return geometry_.hasTags ? *this : rules_; }

  bool pierce(const Entity& entity, const SegmentRef& segment) const override {
    return rules_.pierce(entity, tagged(segment));
  }
  Scope scope() const override { return rules_.scope(); }
  bool mayPierce(std::uint32_t part, std::uint32_t index) const override { return rules_.mayPierce(part, index); }
  void beginContact(Entity& entity, const SegmentRef& segment) override {
    rules_.beginContact(entity, tagged(segment));
  }
  void overContact(Entity& entity, const SegmentRef& segment) override { rules_.overContact(entity, tagged(segment)); }
  void endContact(Entity& entity, const SegmentRef& segment) override { rules_.endContact(entity, tagged(segment)); }
  void contact(Entity& entity, const Contact& contact) override {
    Contact copy = contact;
    copy.segment = tagged(contact.segment);
    rules_.contact(entity, copy);
  }
  void touchContact(Entity& entity, const SegmentRef& segment) override {
    rules_.touchContact(entity, tagged(segment));
  }

 private:
  SegmentRef tagged(const SegmentRef& segment) const {
    SegmentRef copy = segment;
    if (const MapGeometry* part = geometry_.find(segment.part)) copy.tag = part->tagOf(segment.index);
    return copy;
  }

  Rules& rules_;
  const Geometry& geometry_;
};

}  // namespace platon
