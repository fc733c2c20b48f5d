#pragma once

#include <array>
#include <cstdint>
#include <cstdio>
#include <string>

namespace platon::sim {

/// `value` as 16 hexadecimal digits.
inline std::string hexDigits(std::uint64_t value) {
  std::array<char, 17> text{};
  std::snprintf(text.data(), text.size(), "%016llx", static_cast<unsigned long long>(value));
  return text.data();
}

}  // namespace platon::sim
