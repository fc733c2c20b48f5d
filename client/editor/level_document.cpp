#include "client/editor/level_document.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <utility>

namespace platon {
namespace {

constexpr std::size_t kStart = 1;  // index in the header
constexpr std::size_t kGoal = 2;
constexpr std::size_t kHeaderLines = 4;
constexpr std::string_view kBlanks = " \t";
constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";

// The parts of a text line: blanks, words with blanks between them, the rest with the comment and the line end.
struct TextLine {
  std::string_view before;
  std::vector<std::string_view> words;
  std::string_view rest;
};

TextLine partsOf(std::string_view line) {
  const std::size_t end = std::min(line.find_first_of("#\r\n"), line.size());
  const std::string_view content = line.substr(0, end);
  TextLine parts;
  std::size_t last = 0;
  for (std::size_t at = content.find_first_not_of(kBlanks); at != std::string_view::npos;) {
    if (parts.words.empty()) parts.before = content.substr(0, at);
    last = std::min(content.find_first_of(kBlanks, at), content.size());
    parts.words.push_back(content.substr(at, last - at));
    at = content.find_first_not_of(kBlanks, last);
  }
  parts.rest = line.substr(last);
  return parts;
}

double numberOf(std::string_view word) {
  double value = 0;
  std::from_chars(word.data(), word.data() + word.size(), value);
  return value;
}

SegmentWord wordOf(const std::vector<std::string_view>& words) {
  SegmentWord word;
  if (words.size() > 4) word.kind = elementKindOf(words[4]);
  if (words.size() > 5) word.number = static_cast<int>(numberOf(words[5]));
  return word;
}

std::vector<std::string> wordsOf(const EditedSegment& segment) {
  std::vector<std::string> words;
  for (const double value : {segment.a.x, segment.a.y, segment.b.x, segment.b.y})
    words.push_back(coordinateText(value));
  if (!segment.word.kind) return words;
  words.emplace_back(platon::wordOf(*segment.word.kind));
  if (hasNumber(*segment.word.kind)) words.push_back(std::to_string(segment.word.number));
  return words;
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

}  // namespace

std::string coordinateText(double units) {
  const std::int64_t value = std::llround(units * 10000);
  std::string decimals = std::to_string(10000 + std::abs(value) % 10000).substr(1);
  while (!decimals.empty() && decimals.back() == '0') decimals.pop_back();
  return std::string(value < 0 ? "-" : "") + std::to_string(std::abs(value) / 10000) +
         (decimals.empty() ? "" : "." + decimals);
}

LevelDocument::LevelDocument(std::string_view text) {
  setText(text);
  check();
}

std::string LevelDocument::text() const {
  std::string text;
  for (const std::string& line : lines_) text += line;
  return text;
}

void LevelDocument::setText(std::string_view text) {
  lines_.clear();
  while (!text.empty()) {
    const std::size_t length = std::min(text.find('\n'), text.size() - 1) + 1;
    lines_.emplace_back(text.substr(0, length));
    text.remove_prefix(length);
  }
  scan();
}

void LevelDocument::check() {
  LevelResult result = loadLevel(text());
  valid_ = result.level != nullptr;
  if (valid_) level_ = std::move(result.level);
  diagnostics_ = std::move(result.diagnostics);
}

void LevelDocument::scan() {
  segments_.clear();
  textLines_.clear();
  header_.clear();
  faceMarks_.clear();
  for (std::size_t index = 0; index < lines_.size(); ++index) scanLine(index);
}

void LevelDocument::scanLine(std::size_t index) {
  std::string_view line = lines_[index];
  if (index == 0 && line.starts_with(kByteOrderMark)) line.remove_prefix(kByteOrderMark.size());
  const TextLine parts = partsOf(line);
  if (parts.words.empty()) return;
  if (parts.words[0] == "%") {
    faceMarks_.push_back(index);
  } else if (header_.size() < kHeaderLines) {
    header_.push_back(index);
  } else if (parts.words.size() >= 4 && !faceMarks_.empty()) {
    const auto number = [&](std::size_t word) { return numberOf(parts.words[word]); };
    segments_.push_back(
        {static_cast<int>(faceMarks_.size()) - 1, {number(0), number(1)}, {number(2), number(3)}, wordOf(parts.words)});
    textLines_.push_back(index);
  }
}

std::string_view LevelDocument::lineEnd() const { return lines_.front().ends_with("\r\n") ? "\r\n" : "\n"; }

// Of the words that stay the same number, the text is kept: 5.0 does not become 5.
void LevelDocument::rewrite(std::size_t index, const std::vector<std::string>& words) {
  const TextLine parts = partsOf(lines_[index]);
  std::string line(parts.before);
  for (std::size_t i = 0; i < words.size(); ++i) {
    const bool same = i < parts.words.size() && i < 4 && numberOf(parts.words[i]) == numberOf(words[i]);
    const bool together = i > 0 && i < parts.words.size();
    if (together) {
      // The blanks between two words.
      const char* const from = parts.words[i - 1].data() + parts.words[i - 1].size();
      line.append(from, parts.words[i].data());
    } else if (i > 0) {
      line += ' ';
    }
    line += same ? std::string(parts.words[i]) : words[i];
  }
  lines_[index] = line + std::string(parts.rest);
  scan();
}

void LevelDocument::add(const EditedSegment& segment) {
  std::size_t after = faceMarks_[static_cast<std::size_t>(segment.face)];
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    if (segments_[i].face == segment.face) after = textLines_[i];
  }
  if (!lines_[after].ends_with('\n')) lines_[after] += lineEnd();
  lines_.insert(lines_.begin() + static_cast<std::ptrdiff_t>(after) + 1,
                joined(wordsOf(segment)) + std::string(lineEnd()));
  scan();
}

void LevelDocument::replace(std::size_t segment, const EditedSegment& with) {
  if (segments_[segment].face == with.face) return rewrite(textLines_[segment], wordsOf(with));
  erase(segment);
  add(with);
}

void LevelDocument::erase(std::size_t segment) {
  std::vector<bool> only(segments_.size());
  only[segment] = true;
  erase(only);
}

void LevelDocument::erase(const std::vector<bool>& segments) {
  std::vector<std::string> kept;
  std::size_t segment = 0;
  for (std::size_t index = 0; index < lines_.size(); ++index) {
    const bool isSegment = segment < textLines_.size() && textLines_[segment] == index;
    if (!isSegment || !segments[segment++]) {
      kept.push_back(std::move(lines_[index]));
      continue;
    }
    const std::string_view rest = partsOf(lines_[index]).rest;
    const std::size_t comment = rest.find('#');
    if (comment != std::string_view::npos) kept.emplace_back(rest.substr(comment));
  }
  lines_ = std::move(kept);
  scan();
}

void LevelDocument::setStart(const FacePlace& start, int degrees) {
  rewrite(header_[kStart], {std::to_string(start.face), coordinateText(start.place.x), coordinateText(start.place.y),
                            std::to_string(degrees)});
}

void LevelDocument::turnStart(int degrees) {
  const TextLine parts = partsOf(lines_[header_[kStart]]);
  std::vector<std::string> words(parts.words.begin(), parts.words.end());
  words.back() = std::to_string(degrees);
  rewrite(header_[kStart], words);
}

void LevelDocument::setGoal(const FacePlace& goal) {
  rewrite(header_[kGoal], {std::to_string(goal.face), coordinateText(goal.place.x), coordinateText(goal.place.y)});
}

}  // namespace platon
