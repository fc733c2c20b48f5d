#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "platon/game/diagnostics.h"
#include "protocol/files/file_writer.h"
#include "protocol/files/word_reader.h"
#include "protocol/transport/socket_address.h"
#include "server/base/utc_time.h"
#include "server/match/match.h"

namespace platon {

/// All addresses that share their first bits: `192.0.2.0/24`, `2001:db8::/32`, or a single address. A range holds
/// either IPv4 or IPv6 addresses, so `::/0` holds no IPv4 address.
class AddressRange {
 public:
  /// Bits of an address in its IPv6 form, and those of them that all IPv4 addresses share.
  static constexpr unsigned kBits = 128;
  static constexpr unsigned kIpv4Bits = 96;

  /// The range of one address.
  explicit AddressRange(const IpAddress& address) : first_(address) {}
  /// The range with this many fixed bits that starts with those of the address; 0 … kBits.
  static AddressRange around(const IpAddress& address, unsigned bits);
  /// The range of the household of an address: see `IpAddress::household`.
  static AddressRange householdOf(const IpAddress& address);

  /// Reads an address, alone or with `/` and the number of its fixed bits. Refuses a range whose first address has a
  /// bit set that is not fixed, because one of the two is a mistake.
  static std::variant<AddressRange, ParseError> parse(std::string_view text);
  /// Such as `192.0.2.0/24`; a single address without the number of bits.
  std::string text() const;

  bool contains(const IpAddress& address) const;

  const IpAddress& first() const { return first_; }
  /// Fixed bits of the IPv6 form: 0 … kBits; at least kIpv4Bits if the addresses are IPv4.
  unsigned bits() const { return bits_; }

  friend bool operator==(const AddressRange&, const AddressRange&) = default;
  /// By first address, then by number of bits.
  friend bool operator<(const AddressRange& a, const AddressRange& b) {
    return a.first_ != b.first_ ? a.first_ < b.first_ : a.bits_ < b.bits_;
  }

 private:
  AddressRange(const IpAddress& first, unsigned bits) : first_(first), bits_(bits) {}

  IpAddress first_;
  unsigned bits_ = kBits;
};

/// Addresses that may not join.
struct Ban {
  /// Longest reason, bytes: with the sentence around it, it fits kMaxReasonBytes.
  static constexpr std::size_t kMaxReasonBytes = 100;

  AddressRange range;
  std::optional<UtcTime> until;  ///< when the ban ends; nothing: never
  std::string reason;            ///< shown to the player; as `parseBanReason` returns it, perhaps empty

  bool holds(UtcTime now) const { return !until || now < *until; }

  friend bool operator==(const Ban&, const Ban&) = default;
};

/// The sentence for a player who may not join because of a ban; a label of at most kMaxReasonBytes of
/// protocol/limits.h.
std::string refusalOf(const Ban& ban);

/// The text without spaces around it, if it can be the reason of a ban.
std::variant<std::string, ParseError> parseBanReason(std::string_view text);

/// Bans, and the text of the file that holds them. One line is one ban:
///
///     192.0.2.7
///     203.0.113.0/24 until 2026-12-01T18:00:00Z   threw things   # a note that players do not see
///
/// Everything but the first word may be missing. Empty lines and `#` comments are kept when the list changes.
class BanList {
 public:
  /// Longest text, bytes.
  static constexpr std::size_t kMaxBytes = 1024 * 1024;
  /// Most errors that `parse` reports; one more says that there are more.
  static constexpr std::size_t kMaxErrors = 100;

  BanList() = default;
  /// Reads a text, or returns what is wrong with it, in order. `text()` of the result is the text.
  static std::variant<BanList, std::vector<Diagnostic>> parse(std::string_view text);
  std::string text() const;

  /// The ban of an address that lasts longest; null if none holds. Exact loopback (IpAddress::isLoopback) is never
  /// banned, so that a ban of all addresses does not lock out who sits at the machine. Takes logarithmic time. The
  /// pointer is valid until the list changes.
  const Ban* find(const IpAddress& address, UtcTime now) const;
  /// The ban of exactly this range; null if there is none.
  const Ban* find(const AddressRange& range) const;
  /// All bans in the order of the text.
  std::vector<Ban> bans() const;
  std::size_t size() const { return lineOf_.size(); }

  /// Adds a ban at the end of the text, or puts it in the place of the ban of the same range.
  void add(const Ban& ban);
  /// Removes the ban of exactly this range and its line. Returns false if there is none.
  bool remove(const AddressRange& range);
  /// Removes all bans that have ended.
  void removeEnded(UtcTime now);

  friend bool operator==(const BanList&, const BanList&) = default;

 private:
  struct Line {
    std::string text;        // without the line feed
    std::optional<Ban> ban;  // nothing: empty or a comment

    friend bool operator==(const Line&, const Line&) = default;
  };

  void readLine(std::string_view text, std::vector<Diagnostic>& errors);
  bool removeIf(const std::function<bool(const Ban&)>& condition);

  std::vector<Line> lines_;
  bool endsWithLineFeed_ = true;
  std::map<AddressRange, std::size_t> lineOf_;  // index of the line of a ban
  std::set<unsigned> lengths_;                  // of the ranges, bits
};

/// Reads a ban file. On failure returns what is wrong with it, each error as `file:line:column: error: …`.
std::variant<BanList, std::vector<std::string>> readBanFile(const std::string& path);

/// The bans of a running server, and the file that keeps them. Before each change the file is read again, so that what
/// somebody has edited meanwhile is kept. It is no KeptFile: the one who shares it is the operator, whose editor takes
/// no lock, and a file that is missing must not be taken for one without bans.
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

/// Removes all players of a match whose address is banned, connected or not, and tells them why. The address is the one
/// that their last message came from. Returns their number.
std::size_t enforceBans(Match& match, const BanList& bans, UtcTime now);

}  // namespace platon
