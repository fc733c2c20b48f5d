#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace platon {

/// Reads a number of bytes: a whole number from 1 on, which K, M or G may follow for KiB, MiB or GiB. Nothing if the
/// text is anything else, or the number does not fit 64 bits.
std::optional<std::uint64_t> parseByteSize(std::string_view text);

}  // namespace platon
