#pragma once

#include <string>

#include "protocol/transport/enet_layer.h"
#include "tests/fuzz/byte_source.h"

namespace platon::fuzz {

/// Some commands in the layout of ENet, mostly ones that our programs send.
platon::Bytes enetContent(ByteSource& bytes, EnetSender sender);

/// Compares `readEnetCommands` with the rules of docs/protocol.md.
std::string enetContentFault(ByteSpan content, EnetSender sender);

}  // namespace platon::fuzz
