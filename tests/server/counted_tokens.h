#pragma once

#include "server/match.h"

namespace platon {

/// Tokens that differ, and are the same in every run.
inline TokenSource countedTokens() {
  return [next = SessionToken{}]() mutable {
    ++next[0];
    return next;
  };
}

}  // namespace platon
