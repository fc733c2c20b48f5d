#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "client/scene/scene.h"
#include "client/ui/controls/key_names.h"

namespace platon {

/// Lets a player who has reached the goal watch the others.
class Spectator {
 public:
  /// Watches the next other player, by slot, and after the last one the local player again.
  void next() { asked_ = true; }
  /// Directs the camera of the next picture. While the local player is on its way, the camera follows it.
  void direct(Scene& scene, const KeyHints& keys = KeyHints());
  /// Watches nobody, and forgets `next`.
  void reset() { *this = Spectator(); }
  /// What to tell the player of this; empty while there is nobody to watch.
  const std::string& hint() const { return hint_; }

 private:
  void watchNext(const Scene& scene);

  bool asked_ = false;
  std::optional<std::uint32_t> watched_;  // slot
  std::string hint_;
};

}  // namespace platon
