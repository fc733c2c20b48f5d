#pragma once

#include <string>
#include <string_view>

namespace platon {

/// `text`, which must be valid UTF-8, as a JSON string with its quotes. Escapes quotes, backslashes and the control
/// characters below U+0020.
std::string jsonText(std::string_view text);

}  // namespace platon
