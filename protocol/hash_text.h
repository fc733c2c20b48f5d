#pragma once

#include <array>
#include <charconv>
#include <cinttypes>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <string_view>

namespace platon {

inline constexpr std::size_t kHashDigits = 16;

/// A hash in files of text: kHashDigits hexadecimal digits.
inline std::string hashText(std::uint64_t hash) {
  std::array<char, kHashDigits + 1> text{};
  std::snprintf(text.data(), text.size(), "%016" PRIx64, hash);
  return text.data();
}

/// Reads what hashText writes; nothing for every other text.
inline std::optional<std::uint64_t> hashIn(std::string_view text) {
  std::uint64_t hash = 0;
  std::from_chars(text.data(), text.data() + text.size(), hash, 16);
  return text == hashText(hash) ? std::optional(hash) : std::nullopt;
}

}  // namespace platon
