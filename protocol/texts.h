#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace platon {

/// "1 line", "2 lines", "3 presses".
std::string counted(std::size_t count, std::string_view noun);

/// The parts with `between` between each two of them.
std::string joined(const std::vector<std::string>& parts, std::string_view between);

/// `text`, which must be valid UTF-8, as a JSON string with its quotes. Escapes quotes, backslashes and the control
/// characters below U+0020.
std::string jsonText(std::string_view text);

}  // namespace platon
