#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "protocol/transport/server_address.h"
#include "protocol/transport/server_identity.h"
#include "protocol/transport/server_list.h"

namespace platon {

/// The entry of a server in a list of servers (protocol/transport/server_list.h), a file that several servers of this
/// machine may share and that any web server can publish. What the others wrote is kept.
class Announcement {
 public:
  /// `file` is created if it is missing; players join at `address`. Throws ProgramError if the file holds something
  /// else than a list, or an entry that is damaged.
  Announcement(std::string file, const ServerIdentity& identity, ServerAddress address);

  /// Puts the entry of the server with this name into the file, in place of older ones of its key or its address.
  /// Returns why that failed, or an empty text. May wait for the disk, and for other servers that write the file.
  std::string enter(std::string_view name);
  /// Takes the entry out; nothing if it is not there.
  std::string leave();

 private:
  std::string write(const ListedServer* own);

  std::string file_;
  ServerIdentity identity_;
  ServerAddress address_;
};

/// The announcement in `file` at `address`, as isNextServer takes it; nothing without a file. Throws ProgramError, also
/// if there is a file and no address.
std::optional<Announcement> announcementOf(const std::string& file, const std::string& address,
                                           const ServerIdentity& identity);

}  // namespace platon
