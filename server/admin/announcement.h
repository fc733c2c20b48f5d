#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "protocol/files/file_writer.h"
#include "protocol/transport/server_address.h"
#include "protocol/transport/server_identity.h"
#include "protocol/transport/server_list.h"

namespace platon {

/// The entry of a server in a list of servers (protocol/transport/server_list.h), a file that several servers of this
/// machine may share and that any web server can publish. What the others wrote is kept, also where they have the same
/// key: the entry of this server is the one at its address. A thread writes the file, so nothing waits for the disk or
/// for another server that holds the lock of the file, which a change awaits for kLockTime at most.
class Announcement {
 public:
  /// How a change of the entry ended.
  struct Outcome {
    bool enters = false;  ///< the server was to be in the list, or else out of it
    std::string fault;    ///< why that failed; empty: it is so

    friend bool operator==(const Outcome&, const Outcome&) = default;
  };

  /// `file` is created, readable by all, if it is missing; players join at `address`. Throws ProgramError if the file
  /// cannot be read, its folder is missing, or it holds something else than a list, or an entry that is damaged. An
  /// empty file is as a missing one.
  Announcement(const std::string& file, const ServerIdentity& identity, ServerAddress address);

  /// Puts the entry of the server with this name into the file, in place of an older one of its address. `poll` writes.
  void enter(std::string_view name);
  /// Takes the entry out; nothing if it is not there.
  void leave();
  /// Call now and then: starts to write, again after a failure. Returns how the last change ended, once, and of its
  /// failures each reason once in a row.
  std::optional<Outcome> poll(FileWriter::Time now);
  /// Tries once to make the last change, as FileWriter::finish does. Returns how it ended, as `poll` does.
  std::optional<Outcome> finish();

 private:
  void write(bool enters, const std::vector<ListedServer>& own);
  std::optional<Outcome> outcomeOf(const std::optional<std::string>& fault);

  ServerIdentity identity_;
  ServerAddress address_;
  std::unique_ptr<FileWriter> file_;  // its content is what this server contributes to the list
  bool enters_ = false;               // the last change
  bool told_ = true;                  // how it ended
};

/// The announcement in `file` at `address`, as isNextServer takes it; nothing without a file. Throws ProgramError, also
/// if there is a file and no address.
std::optional<Announcement> announcementOf(const std::string& file, const std::string& address,
                                           const ServerIdentity& identity);

}  // namespace platon
