#pragma once

#include <cstdint>
#include <vector>

#include "platon/exact/angle.h"
#include "platon/game/level.h"
#include "platon/physics/entity.h"
#include "platon/physics/rules.h"

namespace platon {

/// Decides which elements of a level block. A level without elements costs nothing: only contacts are asked for then.
class ElementRules : public Rules {
 public:
  /// `level` must outlive the object.
  ElementRules(const Level& level, OpenElements open);

  Scope scope() const override { return elements_.empty() ? Scope::kContacts : Scope::kSegments; }
  bool pierce(const Entity& entity, const SegmentRef& segment) const override;
  bool mayPierce(std::uint32_t part, std::uint32_t index) const override;

 protected:
  /// The elements of the level.
  const std::vector<Element>& elements() const { return elements_; }
  /// The element of the segment, or null.
  const Element* elementOf(const SegmentRef& segment) const {
    return findElement(elements_, segment.part, segment.index);
  }
  /// From the +y of the segment's face to the entity's up.
  static Angle upOnFaceOf(const SegmentRef& segment, const Entity& entity) {
    return entity.rotation() - segment.toHome;
  }

 private:
  const std::vector<Element>& elements_;
  std::int32_t edgesPerFace_;
  OpenElements open_;
};

}  // namespace platon
