#pragma once

#include <span>
#include <string>
#include <string_view>

#include "protocol/transport/noise.h"

namespace platon {

/// The bytes of a text of hexadecimal digits. Throws std::invalid_argument for anything else.
Bytes fromHex(std::string_view text);
CryptoKey keyFromHex(std::string_view text);
std::string toHex(ByteSpan bytes);

}  // namespace platon
