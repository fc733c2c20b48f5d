#pragma once

#include <cstddef>
#include <set>
#include <tuple>
#include <utility>

/// Defines `membersOf(const Struct&)`, which copies the members into a tuple. Does not compile unless each member of
/// the struct has a name here, in their order.
#define PLATON_MEMBERS(Struct, ...)            \
  inline auto membersOf(const Struct& value) { \
    const auto& [__VA_ARGS__] = value;         \
    return std::make_tuple(__VA_ARGS__);       \
  }

namespace platon {

/// The indices of the members that differ.
template <class... Members>
std::set<std::size_t> differing(const std::tuple<Members...>& a, const std::tuple<Members...>& b) {
  std::set<std::size_t> indices;
  const auto compare = [&]<std::size_t... kIndex>(std::index_sequence<kIndex...>) {
    ((std::get<kIndex>(a) == std::get<kIndex>(b) ? void() : void(indices.insert(kIndex))), ...);
  };
  compare(std::index_sequence_for<Members...>());
  return indices;
}

}  // namespace platon
