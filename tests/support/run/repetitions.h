#pragma once

namespace platon {

/// `usual`; in a build with sanitizers a fifth of it, at least 1. Such a build takes ten times as long for each
/// repetition, and the errors that it looks for do not hide behind rare numbers.
template <class Integer>
constexpr Integer repetitions(Integer usual) {
#ifdef PLATON_SANITIZE
  return usual < 5 ? 1 : usual / 5;
#else
  return usual;
#endif
}

}  // namespace platon
