#pragma once

#include <cstddef>
#include <string_view>

namespace platon {

/// Whether the text can be shown on a screen and in a log unchanged: at most `maxBytes` bytes of valid UTF-8 without
/// control characters, line breaks or marks that change the direction of writing. The empty text is a label.
bool isLabel(std::string_view text, std::size_t maxBytes);

}  // namespace platon
