#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "protocol/files/file_writer.h"
#include "server/admin/ban_list.h"

namespace platon {

/// Reads a ban file. On failure returns what is wrong with it, each error as `file:line:column: error: …`.
std::variant<BanList, std::vector<std::string>> readBanFile(const std::string& path);

/// The bans of a running server, and the file that keeps them. Before each change the file is read again, so that what
/// somebody has edited meanwhile is kept.
class BanStore {
 public:
  /// Bans that end with the server.
  BanStore() = default;
  /// Bans that are kept in a file, whose content is `list`.
  BanStore(const std::string& path, BanList list);

  const BanList& list() const { return list_; }
  bool hasFile() const { return file_ != nullptr; }

  /// Adds a ban, or replaces the one of the same range. Nothing changes if the file has an error; it is returned.
  std::optional<ParseError> add(const Ban& ban, UtcTime now);
  /// Removes a ban. Nothing changes if there is none or the file has an error; it is returned.
  std::optional<ParseError> remove(const AddressRange& range, UtcTime now);
  /// Takes over a list that has just been read from the file. Nothing changes if a newer one waits to be written; that
  /// error is returned. No effect without a file.
  std::optional<ParseError> replace(BanList list);

  /// Whether a change is not in the file yet.
  bool pending() const { return file_ && file_->pending(); }
  /// How often the file could not be written so far (FileWriter::failures).
  std::uint64_t failures() const { return file_ ? file_->failures() : 0; }

  /// Call now and then: starts to write the file, again after a failure. Returns, once, why the bans could not be
  /// written.
  std::optional<std::string> poll(FileWriter::Time now);
  /// Writes what is pending, as FileWriter::finish does. Returns why the bans are not in the file.
  std::optional<std::string> finish() { return file_ ? file_->finish() : std::nullopt; }

 private:
  std::optional<ParseError> readAgain();
  void save(UtcTime now);

  std::string path_;
  std::unique_ptr<FileWriter> file_;
  BanList list_;
};

}  // namespace platon
