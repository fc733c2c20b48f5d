#pragma once

#include <string>

namespace platon {

/// Why a text is refused: a clause that says what is wrong and how to correct it, in printable characters.
struct ParseError {
  std::string what;

  friend bool operator==(const ParseError&, const ParseError&) = default;
};

}  // namespace platon
