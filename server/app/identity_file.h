#pragma once

#include <string>

#include "protocol/transport/server_identity.h"
#include "server/app/log.h"

namespace platon {

/// The file of the server's identity if none is named: `server.key` in $STATE_DIRECTORY, which systemd sets, or else in
/// the user's data folder (XDG Base Directory Specification). Empty if there is no such folder.
std::string defaultKeyFile();

/// The identity in `keyFile` (--key-file), which is created if it is missing. An empty `keyFile` means the default one;
/// if that cannot be used, the identity is a new one and the log warns that clients will not recognise the server after
/// a restart. It also warns of a file that others may open. Throws ProgramError if a named file cannot be used.
ServerIdentity loadIdentity(const std::string& keyFile, Log& log);

}  // namespace platon
