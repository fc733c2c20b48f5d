#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "platon/game/diagnostics.h"
#include "protocol/files/parse_error.h"
#include "server/admin/address_range.h"
#include "server/base/utc_time.h"

namespace platon {

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

}  // namespace platon
