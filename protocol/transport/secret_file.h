#pragma once

#include <string>

#include "protocol/transport/server_identity.h"

namespace platon {

/// The password in the first line of a regular file of at most 4096 bytes. Throws ProgramError (kUsage) if the file
/// cannot be read, is something else or larger, or if the line is empty.
std::string readPasswordFile(const std::string& path);

/// The server's identity in a file; creates the file, readable only by its owner, if it is missing. Throws ProgramError
/// (kUsage) if it cannot be read or holds something else, or if it cannot be created as a whole; nothing is left of it
/// then. Several servers may make the same file at once: all of them get the same identity.
ServerIdentity readKeyFile(const std::string& path);

/// Why the file of a key is not safe, with a remedy: as ssh does, if it belongs to the user of this program and others
/// may open it. Else, and without such a file, an empty text.
std::string keyFileWarning(const std::string& path);

/// Throws ProgramError (kUsage) if `readKeyFile` would, but creates no file. Returns whether there is one.
bool checkKeyFile(const std::string& path);

}  // namespace platon
