#pragma once

#include <map>
#include <string>

#include "protocol/bytes.h"

namespace platon {

/// The blocks of docs/protocol.md that begin with "```bytes NAME": hexadecimal bytes, each line up to a '#'.
std::map<std::string, Bytes> documentedBytes();

}  // namespace platon
