#pragma once

#include <set>
#include <string>
#include <utility>

#include "platon/physics/rules.h"
#include "tests/fuzz/fuzz_scene.h"

namespace platon::fuzz {

/// Rules that let every n-th line of a scene pass, and the laws of the calls that a world owes them.
class LineEvents : public Rules {
 public:
  /// `every` 0: none passes. `pairs`: whether beginnings and ends must come in pairs, which they do for entities that
  /// have one instance and do not turn.
  LineEvents(const FuzzScene& scene, std::size_t every, bool pairs) : scene_(scene), every_(every), pairs_(pairs) {}

  bool pierces(std::uint32_t part, std::uint32_t line) const {
    return every_ != 0 && line < scene_.lines[part] && line % every_ == 0;
  }
  bool pierce(const Entity& entity, const SegmentRef& line) const override;
  void beginContact(Entity& entity, const SegmentRef& line) override;
  void overContact(Entity& entity, const SegmentRef& line) override;
  void endContact(Entity& entity, const SegmentRef& line) override;
  void contact(Entity& entity, const Contact& contact) override;
  void touchContact(Entity& entity, const SegmentRef& line) override;

  /// What was wrong since the last call; empty when nothing was.
  std::string finishTick();

 private:
  using Line = std::pair<std::uint32_t, std::uint32_t>;  // entity, line

  void require(bool holds, const char* what, const SegmentRef& line);

  const FuzzScene& scene_;
  std::size_t every_;
  bool pairs_;
  std::set<Line> inside_;
  std::set<Line> over_;
  std::string fault_;
};

}  // namespace platon::fuzz
