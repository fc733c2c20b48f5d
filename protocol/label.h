#pragma once

#include <cstddef>
#include <string_view>

namespace platon {

/// Whether the text may be shown on a screen and in a log as it is: at most `maxBytes` bytes of valid UTF-8 without
/// control characters, line breaks or marks that change the direction of writing. Empty is clean.
bool isLabel(std::string_view text, std::size_t maxBytes);

}  // namespace platon
