#include "tests/fuzz/fixed_random.h"

#include <sodium.h>

#include <cstdint>
#include <random>
#include <span>

namespace platon::fuzz {
namespace {

std::mt19937_64& generator() {
  static std::mt19937_64 random;
  return random;
}

const char* name() { return "fixed"; }

std::uint32_t number() { return static_cast<std::uint32_t>(generator()()); }

void fill(void* buffer, std::size_t size) {
  for (std::uint8_t& byte : std::span(static_cast<std::uint8_t*>(buffer), size)) {
    byte = static_cast<std::uint8_t>(generator()());
  }
}

randombytes_implementation kFixed{&name, &number, nullptr, nullptr, &fill, nullptr};

}  // namespace

FixedRandom::FixedRandom() {
  generator().seed(1);
  randombytes_set_implementation(&kFixed);
}

FixedRandom::~FixedRandom() { randombytes_set_implementation(&randombytes_sysrandom_implementation); }

}  // namespace platon::fuzz
