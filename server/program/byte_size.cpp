#include "server/program/byte_size.h"

#include <charconv>

namespace platon {
namespace {

// Nothing for a text that is no unit.
std::optional<unsigned> bitsOf(std::string_view unit) {
  if (unit.empty()) return 0u;
  if (unit == "K") return 10u;
  if (unit == "M") return 20u;
  if (unit == "G") return 30u;
  return std::nullopt;
}

}  // namespace

std::optional<std::uint64_t> parseByteSize(std::string_view text) {
  std::uint64_t number = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number);
  const auto bits = bitsOf({rest, static_cast<std::size_t>(end - rest)});
  if (error != std::errc{} || !bits || number == 0 || number > UINT64_MAX >> *bits) return std::nullopt;
  return number << *bits;
}

}  // namespace platon
