#pragma once

#include <cstdlib>

namespace platon {

/// Whether the build has sanitizers. It takes ten times as long, and looks for errors that do not hide behind rare
/// numbers.
constexpr bool hasSanitizers() {
#ifdef PLATON_SANITIZE
  return true;
#else
  return false;
#endif
}

/// Whether a law is tested with a fifth of its repetitions: with sanitizers, and where the environment variable
/// PLATON_BRIEF is set, as by `./platon test`, `--quick` and `--all`.
inline bool isBrief() { return hasSanitizers() || std::getenv("PLATON_BRIEF") != nullptr; }

/// `usual`; in a brief run a fifth of it, at least 1.
template <class Integer>
Integer repetitions(Integer usual) {
  if (!isBrief()) return usual;
  return usual < 5 ? 1 : usual / 5;
}

}  // namespace platon
