#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "platon/physics/map_geometry.h"

namespace platon {

class World;

/// Where the handles of a world find it. A link keeps its address when its world moves.
struct WorldLink {
  World* world = nullptr;              ///< null when another world was moved onto the world
  std::unique_ptr<WorldLink> retired;  ///< links that are null, kept so that their handles can be refused
  std::vector<std::uint32_t> begun;    ///< parts with segments or warps for which MapPart::initialize was not called

  explicit WorldLink(World& target) : world(&target) {}
  WorldLink(const WorldLink&) = delete;
  WorldLink& operator=(const WorldLink&) = delete;
  // One after the other: the list may be too long to recurse.
  ~WorldLink() {
    while (retired) retired = std::move(retired->retired);
  }

  /// The world. Throws std::invalid_argument when another one was moved onto it.
  World& target() const {
    if (world == nullptr) refuse();
    return *world;
  }
  /// A part has got its first segment or warp.
  void begin(std::uint32_t part) {
    if (std::find(begun.begin(), begun.end(), part) == begun.end()) begun.push_back(part);
  }
  /// MapPart::initialize was called for the part.
  void end(std::uint32_t part) { std::erase(begun, part); }
  /// Throws std::logic_error when a part was begun that the world does not have.
  void requireInitialised(const Geometry& geometry) const {
    for (const std::uint32_t part : begun) {
      if (geometry.find(part) == nullptr) refuseBegun(part);
    }
  }
  /// Retires `other` and keeps it with those that it has retired.
  void retire(std::unique_ptr<WorldLink> other) {
    other->world = nullptr;
    std::unique_ptr<WorldLink>* end = &retired;
    while (*end) end = &(*end)->retired;
    *end = std::move(other);
  }

 private:
  [[noreturn]] static void refuse();
  [[noreturn]] static void refuseBegun(std::uint32_t part);
};

}  // namespace platon
