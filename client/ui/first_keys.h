#pragma once

#include <cstdint>
#include <string>

#include "client/ui/controls/held_keys.h"
#include "client/ui/controls/key_hints.h"

namespace platon {

/// Teaches a new player the first keys: shows each of them until the player has used it.
class FirstKeys {
 public:
  /// `known`: the player needs none of it.
  explicit FirstKeys(bool known) : step_(known ? Step::kDone : Step::kRun) {}

  /// Notes what the player does in a tick: the keys that are held, and the face that the ball is on.
  void observe(const HeldKeys& held, std::uint32_t face);
  /// What to do next; empty if there is nothing to teach.
  std::string hint(const KeyHints& keys) const;
  bool done() const { return step_ == Step::kDone; }

 private:
  enum class Step { kRun, kJump, kCross, kDone };

  Step step_;
  std::uint32_t ticks_ = 0;  // in which the key of this step was held
  std::uint32_t face_ = 0;   // where the step kCross began
};

}  // namespace platon
