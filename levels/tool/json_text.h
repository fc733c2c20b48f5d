#pragma once

#include <string>
#include <string_view>

namespace platon {

/// `text` as a JSON string, quotes included. Bytes that are no printable ASCII are written as they are when they are
/// part of valid UTF-8, which is the caller's care; control bytes are escaped.
std::string jsonText(std::string_view text);

}  // namespace platon
