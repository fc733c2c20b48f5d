#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "platon/game/diagnostics.h"

namespace platon::fuzz {

/// Whether a text can be shown in one line.
inline bool isPrintable(std::string_view text) {
  return std::all_of(text.begin(), text.end(), [](char byte) { return byte >= ' ' && byte <= '~'; });
}

/// What is wrong with the errors that were found in a text, of which a reader lists so many at most; empty: nothing.
inline std::string errorsFault(const std::vector<Diagnostic>& errors, std::size_t maxErrors, std::string_view text) {
  if (errors.empty() || errors.size() > maxErrors + 1) return "no error, or too many";
  const auto lines = std::count(text.begin(), text.end(), '\n') + 1;
  int line = 1;
  for (const Diagnostic& one : errors) {
    const bool inText = one.line >= line && one.line <= lines && one.column >= 1 &&
                        one.column <= static_cast<std::int64_t>(text.size()) + 1;
    if (!inText) return "an error outside the text or out of order";
    line = one.line;
    if (!isPrintable(one.message)) return "an unprintable message";
  }
  return {};
}

}  // namespace platon::fuzz
