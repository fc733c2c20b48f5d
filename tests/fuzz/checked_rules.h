#pragma once

#include <set>
#include <string>
#include <tuple>

#include "platon/physics/rules.h"
#include "tests/fuzz/fuzz_scene.h"

namespace platon::fuzz {

/// Rules that make every n-th segment of a scene pierceable and check the calls that a world makes.
class CheckedRules : public Rules {
 public:
  /// `every` = 0: no segment is pierceable.
  CheckedRules(const FuzzScene& scene, std::size_t every) : scene_(scene), every_(every) {}

  bool pierces(std::uint32_t part, std::uint32_t line) const {
    return every_ != 0 && line < scene_.lines[part] && line % every_ == 0;
  }
  bool pierce(const Entity& entity, const SegmentRef& segment) const override;
  void beginContact(Entity& entity, const SegmentRef& segment) override;
  void overContact(Entity& entity, const SegmentRef& segment) override;
  void endContact(Entity& entity, const SegmentRef& segment) override;
  void contact(Entity& entity, const Contact& contact) override;
  void touchContact(Entity& entity, const SegmentRef& segment) override;

  /// Returns the first fault since the last call; empty if there is none.
  std::string finishTick();

 private:
  using Overlap = std::tuple<std::uint32_t, std::uint16_t, std::uint32_t, std::uint32_t>;  // entity to segment

  static Overlap overlapOf(const Entity& entity, const SegmentRef& segment) {
    return {entity.index(), segment.instance, segment.part, segment.index};
  }

  void require(bool holds, const char* what, const SegmentRef& segment);

  const FuzzScene& scene_;
  std::size_t every_;
  std::set<Overlap> inside_;
  std::set<Overlap> over_;
  std::string fault_;
};

}  // namespace platon::fuzz
