#pragma once

#include "platon/game/level.h"

namespace platon {

/// Whether two levels are the same, also if somebody has made one that has the hash of the other.
inline bool isSameLevel(const Level& a, const Level& b) { return &a == &b || (a.hash == b.hash && a.text == b.text); }

}  // namespace platon
