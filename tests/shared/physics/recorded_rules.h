#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "platon/physics/rules.h"

namespace platon {

/// Writes down every call: "begin 1:3" is the beginning of a contact with line 3 of part 1.
class RecordedRules : public Rules {
 public:
  /// Lines that are passed through besides warps, by part and index; warps in `walls` are not.
  std::set<std::pair<std::uint32_t, std::uint32_t>> pierceable;
  std::set<std::pair<std::uint32_t, std::uint32_t>> walls;
  std::vector<std::string> calls;
  std::vector<Contact> contacts;

  bool pierce(const Entity&, const SegmentRef& line) const override {
    return line.warp ? !walls.contains({line.part, line.index}) : pierceable.contains({line.part, line.index});
  }
  void beginContact(Entity&, const SegmentRef& line) override { note("begin", line); }
  void overContact(Entity&, const SegmentRef& line) override { note("over", line); }
  void endContact(Entity&, const SegmentRef& line) override { note("end", line); }
  void contact(Entity&, const Contact& contact) override {
    note("contact", contact.segment);
    contacts.push_back(contact);
  }
  void touchContact(Entity&, const SegmentRef& line) override { note("touch", line); }

  /// What was called since the last question.
  std::vector<std::string> take() { return std::exchange(calls, {}); }

 private:
  void note(const char* what, const SegmentRef& line) {
    calls.push_back(std::string(what) + " " + std::to_string(line.part) + ":" + std::to_string(line.index));
  }
};

}  // namespace platon
