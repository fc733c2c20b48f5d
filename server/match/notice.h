#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace platon {

/// The message that shows a text from the operator of the server to a player for some seconds. The text is a label of
/// at most kMaxReasonBytes. Returns nothing, because this version of the protocol has no such message.
inline std::optional<std::vector<std::uint8_t>> encodeNotice(const std::string&) { return std::nullopt; }

}  // namespace platon
