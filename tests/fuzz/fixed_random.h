#pragma once

namespace platon::fuzz {

/// While one exists, the random numbers of libsodium are the same in every run, so that a fuzzer's input always does
/// the same. Only one may exist at a time.
class FixedRandom {
 public:
  FixedRandom();
  ~FixedRandom();
  FixedRandom(const FixedRandom&) = delete;
  FixedRandom& operator=(const FixedRandom&) = delete;
};

}  // namespace platon::fuzz
