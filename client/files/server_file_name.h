#pragma once

#include <string>

#include "protocol/transport/server_address.h"

namespace platon {

/// Name of a file or folder for a server: HOST_PORT. The host is user input: characters that could form a path are
/// percent-encoded.
std::string serverFileName(const ServerAddress& server);

}  // namespace platon
