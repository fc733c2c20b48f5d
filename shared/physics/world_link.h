#pragma once

#include <memory>
#include <utility>

namespace platon {

class World;

/// Where the handles of a world find it. A link keeps its address when its world moves.
struct WorldLink {
  World* world = nullptr;              ///< null when another world was moved onto the world
  std::unique_ptr<WorldLink> retired;  ///< links that are null, kept so that their handles can be refused

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
  /// Retires `other` and keeps it with those that it has retired.
  void retire(std::unique_ptr<WorldLink> other) {
    other->world = nullptr;
    std::unique_ptr<WorldLink>* end = &retired;
    while (*end) end = &(*end)->retired;
    *end = std::move(other);
  }

 private:
  [[noreturn]] static void refuse();
};

}  // namespace platon
