#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "platon/game/diagnostics.h"
#include "platon/game/element.h"
#include "platon/game/level_text.h"

namespace platon {

/// Reads what follows the four numbers of a segment: a word, and its numbers.
/// `words` is not empty; `edges` is the number of edges of a face. Reports every error and returns nothing then.
std::optional<ElementWord> readElementWord(const LevelLine& line, std::span<const LevelToken> words,
                                           std::uint32_t edges, Diagnostics& diagnostics);

}  // namespace platon
