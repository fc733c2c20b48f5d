#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "platon/physics/rules.h"

namespace platon {

/// Records every call as text: "begin 1:3" is beginContact with segment 3 of part 1.
class RecordedRules : public Rules {
 public:
  /// Segments that can be passed in addition to warps, and warps that block, by part and index.
  std::set<std::pair<std::uint32_t, std::uint32_t>> pierceable;
  std::set<std::pair<std::uint32_t, std::uint32_t>> walls;
  std::vector<std::string> calls;
  std::vector<Contact> contacts;

  bool pierce(const Entity&, const SegmentRef& segment) const override {
    return segment.warp ? !walls.contains({segment.part, segment.index})
                        : pierceable.contains({segment.part, segment.index});
  }
  void beginContact(Entity&, const SegmentRef& segment) override { note("begin", segment); }
  void overContact(Entity&, const SegmentRef& segment) override { note("over", segment); }
  void endContact(Entity&, const SegmentRef& segment) override { note("end", segment); }
  void contact(Entity&, const Contact& contact) override {
    note("contact", contact.segment);
    contacts.push_back(contact);
  }
  void touchContact(Entity&, const SegmentRef& segment) override { note("touch", segment); }

  /// Returns and clears the recorded calls.
  std::vector<std::string> take() { return std::exchange(calls, {}); }

 private:
  void note(const char* what, const SegmentRef& segment) {
    calls.push_back(std::string(what) + " " + std::to_string(segment.part) + ":" + std::to_string(segment.index));
  }
};

}  // namespace platon
