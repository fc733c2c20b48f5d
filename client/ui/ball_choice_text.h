#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "client/scene/palette.h"

namespace platon {

/// The words of the settings file for a colour or a pattern; `auto` for none chosen.
std::string wordOf(std::optional<std::uint32_t> colour);
std::string wordOf(std::optional<BallPattern> pattern);

/// Stores what the word names and returns true; returns false if it names nothing.
bool parse(std::string_view word, std::optional<std::uint32_t>& colour);
bool parse(std::string_view word, std::optional<BallPattern>& pattern);

/// All words, for a message: `auto, orange, …`.
std::string ballColourWords();
std::string ballPatternWords();

}  // namespace platon
