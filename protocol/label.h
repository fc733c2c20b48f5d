#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace platon {

/// Whether the text can be shown on a screen and in a log unchanged: at most `maxBytes` bytes of valid UTF-8 without
/// control characters, line breaks or marks that change the direction of writing. The empty text is a label.
bool isLabel(std::string_view text, std::size_t maxBytes);

/// What a reader sees of a label: without invisible characters, such as those of width zero, and without combining
/// characters that have nothing to combine with; with one plain space for each run of spaces, and none at the ends. Not
/// longer than the label. Empty if nothing of the label can be seen.
std::string visibleLabel(std::string_view label);

/// A key that is equal for labels that a reader takes for the same: those of the same visible characters, in capitals
/// or not.
std::u32string lookAlikeKey(std::string_view label);

}  // namespace platon
