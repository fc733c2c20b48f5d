#pragma once

#include <utility>

namespace platon {

/// Asks a player who is alone once more before it leaves a level whose goal it has not reached.
class SkipQuestion {
 public:
  /// The player wishes the next level. Returns whether to go there: at once if the goal is `reached`, else when the
  /// player wishes it a second time.
  bool wish(bool reached) { return std::exchange(asked_, !reached && !asked_) || reached; }
  /// The player does something else.
  void takeBack() { asked_ = false; }
  /// Whether the question is open.
  bool asked() const { return asked_; }

 private:
  bool asked_ = false;
};

}  // namespace platon
