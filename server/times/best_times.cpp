#include "server/times/best_times.h"

#include <algorithm>
#include <charconv>
#include <utility>

#include "platon/game/game.h"
#include "protocol/files/private_file.h"
#include "protocol/files/word_reader.h"
#include "protocol/hash_text.h"
#include "protocol/label.h"
#include "protocol/limits.h"

namespace platon {
namespace {

constexpr std::string_view kHead =
    "# Best times: hash of the level, version of the rules, ticks (60 a second), date, name of the player.\n";
constexpr std::size_t kMaxLineBytes = kHashDigits + 10 + 10 + 20 + kMaxNameBytes + 5;  // five separators
static_assert(kHead.size() + BestTimes::kMaxTimes * kMaxLineBytes <= BestTimes::kMaxBytes);

// Nothing if the text is not the number in its shortest form.
std::optional<std::uint32_t> numberOf(std::string_view text) {
  std::uint32_t number = 0;
  std::from_chars(text.data(), text.data() + text.size(), number);
  return text == std::to_string(number) ? std::optional(number) : std::nullopt;
}

// The date is written with its time of day.
std::optional<UtcTime> dateOf(std::string_view text) {
  const std::optional<UtcTime> date = parseUtcTime(text);
  return date && formatUtcTime(*date) == text ? date : std::nullopt;
}

using Entry = std::pair<PlayedLevel, DatedTime>;

// The best time of a line, or what is wrong with it and in which column.
struct TimeReader : LineReader {
  std::variant<Entry, ParseError> read() {
    const auto hash = hashIn(next());
    if (!hash) return ParseError{"a line must begin with the hash of a level, 16 digits 0 to 9 and a to f"};
    const auto rules = numberOf(next());
    if (!rules) return ParseError{"the hash must be followed by the version of the rules, a whole number"};
    const auto ticks = numberOf(next());
    const bool possible = ticks && *ticks >= 1 && (*rules != kRulesVersion || *ticks <= kMaxBestTicks);
    if (!possible) {
      return ParseError{"the version must be followed by the ticks to the goal, 1 to " + std::to_string(kMaxBestTicks)};
    }
    const auto date = dateOf(next());
    if (!date) return ParseError{"the ticks must be followed by the date in UTC, such as 2026-12-01T18:00:00Z"};
    const std::string_view label = rest();
    const std::string name = visibleLabel(label);
    if (name.empty() || !isLabel(label, kMaxNameBytes))
      return ParseError{"the date must be followed by the name of the player, at most 32 bytes of text"};
    return Entry{{*hash, *rules}, {{*ticks, name}, *date}};
  }
};
static_assert(kMaxNameBytes == 32);

}  // namespace

std::variant<BestTimes, std::vector<Diagnostic>> BestTimes::parse(std::string_view text) {
  BestTimes times;
  std::vector<Diagnostic> errors;
  for (TextLines lines(text); errors.size() < kMaxErrors && lines.nextEntry();) {
    TimeReader line{{WordReader(lines.line())}};
    auto read = line.read();
    if (const auto* error = std::get_if<ParseError>(&read)) {
      errors.push_back({lines.number(), line.column, true, error->what + "; correct or remove the line"});
    } else if (!times.times_.insert(std::get<Entry>(std::move(read))).second) {
      errors.push_back({lines.number(), 1, true, "two times for this level and these rules; remove one of them"});
    }
  }
  times.limit();
  if (errors.empty()) return times;
  if (errors.size() == kMaxErrors) errors.push_back({errors.back().line, 1, true, "too many errors; fix these first"});
  return errors;
}

std::string BestTimes::text() const {
  std::string text(kHead);
  for (const auto& [level, best] : times_) {
    text += hashText(level.hash) + " " + std::to_string(level.rules) + " " + std::to_string(best.time.ticks) + " " +
            formatUtcTime(best.date) + " " + best.time.name + "\n";
  }
  return text;
}

const DatedTime* BestTimes::find(const PlayedLevel& level) const {
  const auto found = times_.find(level);
  return found == times_.end() ? nullptr : &found->second;
}

bool BestTimes::offer(const PlayedLevel& level, const DatedTime& time) {
  const bool taken = take(level, time);
  limit();
  return taken;
}

void BestTimes::merge(const BestTimes& others) {
  for (const auto& [level, time] : others.times_) take(level, time);
  limit();
}

bool BestTimes::take(const PlayedLevel& level, const DatedTime& time) {
  const auto [place, isNew] = times_.try_emplace(level, time);
  if (!isNew && place->second.time.ticks <= time.time.ticks) return false;
  place->second = time;
  return true;
}

void BestTimes::limit() {
  if (times_.size() <= kMaxTimes) return;
  std::vector<std::map<PlayedLevel, DatedTime>::const_iterator> oldestFirst;
  for (auto each = times_.cbegin(); each != times_.cend(); ++each) oldestFirst.push_back(each);
  std::stable_sort(oldestFirst.begin(), oldestFirst.end(),
                   [](const auto& a, const auto& b) { return a->second.date < b->second.date; });
  oldestFirst.resize(times_.size() - kMaxTimes);
  for (const auto& each : oldestFirst) times_.erase(each);
}

namespace {

KeptFile keptAt(const std::string& path) { return {path, BestTimes::kMaxBytes, KeptFile::Kind::kNamed}; }

std::variant<BestTimes, std::vector<std::string>> timesIn(const std::string& path, const std::string& text) {
  auto parsed = BestTimes::parse(text);
  if (auto* times = std::get_if<BestTimes>(&parsed)) return std::move(*times);
  std::vector<std::string> errors;
  for (const Diagnostic& one : std::get<std::vector<Diagnostic>>(parsed)) errors.push_back(format(path, one));
  return errors;
}

}  // namespace

std::variant<BestTimes, std::vector<std::string>> readBestTimes(const std::string& path) {
  const auto text = keptAt(path).read();
  if (const auto* error = std::get_if<ParseError>(&text)) return std::vector{path + ": error: " + error->what};
  return timesIn(path, std::get<std::string>(text));
}

std::string addBestTimes(const std::string& path, std::string_view text) {
  const auto add = [&](const std::string& kept) -> std::variant<std::string, ParseError> {
    auto read = timesIn(path, kept);
    if (const auto* errors = std::get_if<std::vector<std::string>>(&read)) return ParseError{errors->front()};
    BestTimes& times = std::get<BestTimes>(read);
    times.merge(std::get<BestTimes>(BestTimes::parse(text)));
    return times.text();
  };
  return keptAt(path).change(add);
}

BestTimeStore::BestTimeStore(Clock clock, const std::string& path, BestTimes times)
    : clock_(std::move(clock)),
      times_(std::move(times)),
      kept_(times_),
      file_(std::make_unique<FileWriter>(path, startThread, addBestTimes)) {}

std::optional<BestTime> BestTimeStore::best(std::uint64_t level) const {
  const DatedTime* best = times_.find({level, kRulesVersion});
  return best ? std::optional(best->time) : std::nullopt;
}

bool BestTimeStore::offer(std::uint64_t level, const BestTime& time, bool lasts) {
  const PlayedLevel played{level, kRulesVersion};
  const DatedTime dated{time, clock_()};
  const bool isBest = times_.offer(played, dated);
  if (!file_ || !lasts || !kept_.offer(played, dated)) return isBest;
  if (!file_->pending()) unwritten_ = BestTimes();
  unwritten_.offer(played, dated);
  file_->write(unwritten_.text());
  return isBest;
}

std::optional<std::string> BestTimeStore::poll(FileWriter::Time now) { return file_ ? file_->poll(now) : std::nullopt; }

}  // namespace platon
