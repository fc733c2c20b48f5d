#include "server/admin/bans.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <utility>

#include "platon/game/diagnostics.h"
#include "protocol/files/text_file.h"
#include "protocol/files/word_reader.h"
#include "protocol/label.h"

namespace platon {
namespace {

constexpr unsigned kHouseholdBits = 64;

std::optional<IpAddress> addressOf(std::string_view text) {
  return text.find('\0') == std::string_view::npos ? IpAddress::parse(text) : std::nullopt;
}

// The address with all bits but the first `bits` cleared.
IpAddress masked(IpAddress address, unsigned bits) {
  for (unsigned i = 0; i < address.bytes.size(); ++i) {
    const unsigned kept = bits > 8 * i ? std::min(bits - 8 * i, 8u) : 0;
    address.bytes[i] = static_cast<std::uint8_t>(address.bytes[i] & (0xff00u >> kept));
  }
  return address;
}

}  // namespace

AddressRange AddressRange::around(const IpAddress& address, unsigned bits) { return {masked(address, bits), bits}; }

AddressRange AddressRange::householdOf(const IpAddress& address) {
  return around(address, address.holdsIpv4() ? kBits : kHouseholdBits);
}

std::variant<AddressRange, ParseError> AddressRange::parse(std::string_view text) {
  const std::size_t slash = text.find('/');
  const auto address = addressOf(text.substr(0, slash));
  if (!address) {
    return ParseError{quoted(text) +
                      " is not an address or a range of addresses; write one such as 192.0.2.7 or 2001:db8::/32"};
  }
  if (slash == std::string_view::npos) return AddressRange(*address);
  const std::string_view number = text.substr(slash + 1);
  const bool dotted = text.find(':') == std::string_view::npos;
  const unsigned most = dotted ? kBits - kIpv4Bits : kBits;
  unsigned bits = 0;
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), bits);
  if (error != std::errc() || end != number.data() + number.size() || bits > most) {
    return ParseError{"the number after the / of " + quoted(text) + " must be 0 to " + std::to_string(most)};
  }
  if (dotted) bits += kIpv4Bits;
  const AddressRange range = around(*address, bits);
  if (range.first_ == *address) return range;
  return ParseError{quoted(text) + " has bits set after its first " + std::string(number) + ": write " + range.text()};
}

std::string AddressRange::text() const {
  if (bits_ == kBits) return first_.text();
  return first_.text() + "/" + std::to_string(first_.isIpv4() ? bits_ - kIpv4Bits : bits_);
}

bool AddressRange::contains(const IpAddress& address) const {
  return address.isIpv4() == first_.isIpv4() && masked(address, bits_) == first_;
}

namespace {

constexpr std::string_view kUntil = "until";

std::string lineOf(const Ban& ban) {
  std::string line = ban.range.text();
  if (ban.until) line += " until " + formatUtcTime(*ban.until);
  return ban.reason.empty() ? line : line + " " + ban.reason;
}

std::string_view commentOf(std::string_view line) { return line.substr(std::min(line.find('#'), line.size())); }

// A ban read from a line, or what is wrong with it and in which column.
struct BanReader : LineReader {
  std::variant<Ban, ParseError> read() {
    auto range = AddressRange::parse(next());
    if (auto* error = std::get_if<ParseError>(&range)) return std::move(*error);
    Ban ban{std::get<AddressRange>(range), std::nullopt, {}};
    if (words.peek() == kUntil) {
      next();
      ban.until = parseUtcTime(next());
      if (!ban.until) {
        return ParseError{"'until' must be followed by a time in UTC, such as 2026-12-01 or 2026-12-01T18:00:00Z"};
      }
    }
    auto reason = parseBanReason(rest());
    if (auto* error = std::get_if<ParseError>(&reason)) return std::move(*error);
    ban.reason = std::get<std::string>(std::move(reason));
    return ban;
  }
};

}  // namespace

std::string refusalOf(const Ban& ban) {
  std::string text = "you are banned from this server";
  if (ban.until) text += " until " + formatUtcTime(*ban.until);
  return ban.reason.empty() ? text : text + ": " + ban.reason;
}

std::variant<std::string, ParseError> parseBanReason(std::string_view text) {
  const WordReader words(text);
  const std::string_view reason = words.rest();
  const bool plain = isLabel(reason, Ban::kMaxReasonBytes) && reason.find('#') == std::string_view::npos;
  if (plain && words.peek() != kUntil) return std::string(reason);
  return ParseError{"the reason must have at most " + std::to_string(Ban::kMaxReasonBytes) +
                    " bytes of text, without control characters or #, and must not begin with 'until'"};
}

std::variant<BanList, std::vector<Diagnostic>> BanList::parse(std::string_view text) {
  if (text.size() > kMaxBytes) {
    return std::vector{Diagnostic{1, 1, true, "the file has more than " + std::to_string(kMaxBytes) + " bytes"}};
  }
  BanList list;
  std::vector<Diagnostic> errors;
  list.endsWithLineFeed_ = text.empty() || text.back() == '\n';
  while (!text.empty() && errors.size() < kMaxErrors) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    list.readLine(text.substr(0, end), errors);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  if (errors.empty()) return list;
  if (errors.size() == kMaxErrors) errors.push_back({errors.back().line, 1, true, "too many errors; fix these first"});
  return errors;
}

void BanList::readLine(std::string_view text, std::vector<Diagnostic>& errors) {
  lines_.push_back({std::string(text), std::nullopt});
  std::string_view content = text.substr(0, text.size() - commentOf(text).size());
  if (content.ends_with('\r')) content.remove_suffix(1);
  BanReader line{{WordReader(content)}};
  if (line.words.peek().empty()) return;
  auto ban = line.read();
  const auto fail = [&](int column, std::string what) {
    errors.push_back({static_cast<int>(lines_.size()), column, true, std::move(what)});
  };
  if (auto* error = std::get_if<ParseError>(&ban)) return fail(line.column, std::move(error->what));
  lines_.back().ban = std::get<Ban>(std::move(ban));
  const AddressRange& range = lines_.back().ban->range;
  const auto [other, isNew] = lineOf_.emplace(range, lines_.size() - 1);
  lengths_.insert(range.bits());
  if (!isNew) {
    fail(1, range.text() + " is banned in line " + std::to_string(other->second + 1) +
                " already: remove one of the two lines");
  }
}

std::string BanList::text() const {
  std::string text;
  for (const Line& line : lines_) text += line.text + "\n";
  if (!endsWithLineFeed_) text.pop_back();
  return text;
}

const Ban* BanList::find(const IpAddress& address, UtcTime now) const {
  if (address.isLoopback()) return nullptr;
  const Ban* longest = nullptr;
  for (const unsigned bits : lengths_) {
    const Ban* ban = find(AddressRange::around(address, bits));
    if (!ban || !ban->range.contains(address) || !ban->holds(now)) continue;
    const bool longer = !longest || (longest->until && (!ban->until || *ban->until > *longest->until));
    if (longer) longest = ban;
  }
  return longest;
}

const Ban* BanList::find(const AddressRange& range) const {
  const auto found = lineOf_.find(range);
  return found == lineOf_.end() ? nullptr : &*lines_[found->second].ban;
}

std::vector<Ban> BanList::bans() const {
  std::vector<Ban> all;
  for (const Line& line : lines_) {
    if (line.ban) all.push_back(*line.ban);
  }
  return all;
}

void BanList::add(const Ban& ban) {
  const auto [place, isNew] = lineOf_.emplace(ban.range, lines_.size());
  if (isNew) {
    lines_.push_back({lineOf(ban), ban});
    lengths_.insert(ban.range.bits());
    endsWithLineFeed_ = true;
    return;
  }
  Line& line = lines_[place->second];
  const std::string_view comment = commentOf(line.text);
  line = {lineOf(ban) + (comment.empty() ? "" : "  ") + std::string(comment), ban};
}

bool BanList::remove(const AddressRange& range) {
  return removeIf([&range](const Ban& ban) { return ban.range == range; });
}

void BanList::removeEnded(UtcTime now) {
  removeIf([now](const Ban& ban) { return !ban.holds(now); });
}

bool BanList::removeIf(const std::function<bool(const Ban&)>& condition) {
  const auto goes = [&condition](const Line& line) { return line.ban && condition(*line.ban); };
  endsWithLineFeed_ = endsWithLineFeed_ || goes(lines_.back());  // that of the line before the last one
  if (std::erase_if(lines_, goes) == 0) return false;
  lineOf_.clear();
  lengths_.clear();
  for (std::size_t number = 0; number < lines_.size(); ++number) {
    if (!lines_[number].ban) continue;
    lineOf_.emplace(lines_[number].ban->range, number);
    lengths_.insert(lines_[number].ban->range.bits());
  }
  return true;
}

namespace {

// Longest line of a ban that the server adds.
constexpr std::size_t kMaxBanBytes = 256;

}  // namespace

std::variant<BanList, std::vector<std::string>> readBanFile(const std::string& path) {
  auto text = readTextFile(path, BanList::kMaxBytes);
  if (const auto* error = std::get_if<ParseError>(&text)) {
    return std::vector{path + ": error: " + error->what + "; name a readable ban file; it may be empty"};
  }
  auto parsed = BanList::parse(std::get<std::string>(text));
  if (auto* list = std::get_if<BanList>(&parsed)) return std::move(*list);
  std::vector<std::string> errors;
  for (const Diagnostic& one : std::get<std::vector<Diagnostic>>(parsed)) errors.push_back(format(path, one));
  return errors;
}

BanStore::BanStore(const std::string& path, BanList list)
    : path_(path), file_(std::make_unique<FileWriter>(path)), list_(std::move(list)) {}

std::optional<ParseError> BanStore::add(const Ban& ban, UtcTime now) {
  if (auto error = readAgain()) return error;
  if (list_.text().size() + kMaxBanBytes > BanList::kMaxBytes) {
    return ParseError{"the ban file is full: remove bans from it"};
  }
  list_.add(ban);
  save(now);
  return std::nullopt;
}

std::optional<ParseError> BanStore::remove(const AddressRange& range, UtcTime now) {
  if (auto error = readAgain()) return error;
  if (!list_.remove(range)) {
    const Ban* other = list_.find(range.first(), now);
    const bool wider = other && other->range.bits() < range.bits();
    return ParseError{
        "there is no ban of " + range.text() +
        (wider ? "; the ban of " + other->range.text() + " includes it" : "; the command 'bans' lists all of them")};
  }
  save(now);
  return std::nullopt;
}

std::optional<ParseError> BanStore::replace(BanList list) {
  if (!file_) return std::nullopt;
  if (pending()) {
    return ParseError{path_ +
                      ": error: the last change of the bans has not been written to this file yet, and will replace "
                      "what is in it; reload again when it has been written"};
  }
  list_ = std::move(list);
  return std::nullopt;
}

std::optional<std::string> BanStore::poll(FileWriter::Time now) { return file_ ? file_->poll(now) : std::nullopt; }

// A file that does not hold the newest list yet is older than the list.
std::optional<ParseError> BanStore::readAgain() {
  if (!file_ || pending()) return std::nullopt;
  auto read = readBanFile(path_);
  if (const auto* errors = std::get_if<std::vector<std::string>>(&read)) {
    return ParseError{errors->front() + "; nothing has changed: correct the file first"};
  }
  list_ = std::get<BanList>(std::move(read));
  return std::nullopt;
}

void BanStore::save(UtcTime now) {
  list_.removeEnded(now);
  if (file_) file_->write(list_.text());
}

std::size_t enforceBans(Match& match, const BanList& bans, UtcTime now) {
  const std::size_t before = match.allPlayers();
  for (const PlayerStatus& player : match.playerStatus()) {
    if (player.companionOf) continue;  // goes with the first player of its connection
    if (const Ban* ban = bans.find(player.address, now)) match.kick(player.slot, refusalOf(*ban));
  }
  return before - match.allPlayers();
}

}  // namespace platon
