#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "platon/game/level.h"

namespace platon {

/// Returns the first `maxBytes` bytes of a file or of a pipe that is written to. Returns nothing and sets `fault` when
/// it cannot be read, or is a device.
std::optional<std::string> readInputFile(const std::string& path, std::size_t maxBytes, std::string& fault);

/// Loads a level file and prints its errors and warnings to stderr, each as `file:line:column: error: …` and the text
/// marked; with advice also those of warningsOf, which take seconds. Returns nothing, and prints why, when the file
/// cannot be read.
std::optional<LevelResult> loadLevelFile(const std::string& path, bool withAdvice = false);

/// Prints diagnostics of `text` to stderr: each as `file:line:column: error: …`, and below it the line of the text with
/// a mark at the column.
void print(const std::string& path, std::string_view text, const std::vector<Diagnostic>& diagnostics);

}  // namespace platon
