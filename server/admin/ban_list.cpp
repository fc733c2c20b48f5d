#include "server/admin/ban_list.h"

#include <algorithm>
#include <utility>

#include "protocol/files/word_reader.h"
#include "protocol/label.h"

namespace platon {
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
        return ParseError{"after 'until' must stand a time in UTC, such as 2026-12-01 or 2026-12-01T18:00:00Z"};
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
                    " bytes of text, without control characters and #, and must not begin with 'until'"};
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

}  // namespace platon
