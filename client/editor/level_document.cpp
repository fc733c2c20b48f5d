#include "client/editor/level_document.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "levels/drawing/level_marks.h"
#include "levels/drawing/solid_frame.h"
#include "protocol/texts.h"

namespace platon {
namespace {

constexpr std::size_t kStart = 1;  // index in the header
constexpr std::size_t kGoal = 2;

double numberOf(std::string_view word) {
  double value = 0;
  std::from_chars(word.data(), word.data() + word.size(), value);
  return value;
}

EditedSegment segmentOf(const LevelLine& line) {
  const auto number = [&](std::size_t token) { return numberOf(line.tokens[token].text); };
  EditedSegment segment{line.face, {number(0), number(1)}, {number(2), number(3)}, {}};
  if (line.tokens.size() > 4) segment.word.kind = elementKindOf(line.tokens[4].text);
  for (std::size_t i = 0; i < std::min<std::size_t>(2, std::max<std::size_t>(line.tokens.size(), 5) - 5); ++i)
    segment.word.numbers[i] = static_cast<int>(number(5 + i));
  return segment;
}

std::vector<std::string> wordsOf(const EditedSegment& segment) {
  std::vector<std::string> words;
  for (const double value : {segment.a.x, segment.a.y, segment.b.x, segment.b.y})
    words.push_back(coordinateText(value));
  if (!segment.word.kind) return words;
  words.emplace_back(platon::wordOf(*segment.word.kind));
  for (std::size_t i = 0; i < segment.word.count(); ++i) words.push_back(std::to_string(segment.word.numbers[i]));
  return words;
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
  LevelText lines(text);
  for (LevelLine line; lines.next(line);) lines_.emplace_back(line.text);
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
  const std::string text = this->text();
  LevelText lines(text);
  for (LevelLine line; lines.next(line);) note(line);
}

void LevelDocument::note(const LevelLine& line) {
  const auto index = static_cast<std::size_t>(line.number) - 1;
  switch (line.role) {
    case LevelLine::Role::kNone:
      return;
    case LevelLine::Role::kHeader:
      return header_.push_back(index);
    case LevelLine::Role::kFaceMark:
      return faceMarks_.push_back(index);
    case LevelLine::Role::kSegment:
      if (line.tokens.size() < 4 || line.face < 0) return;
      segments_.push_back(segmentOf(line));
      textLines_.push_back(index);
  }
}

std::string_view LevelDocument::lineEnd() const { return lines_.front().ends_with("\r\n") ? "\r\n" : "\n"; }

// Of the words that stay the same number, the text is kept: 5.0 does not become 5.
void LevelDocument::rewrite(std::size_t index, const std::vector<std::string>& words) {
  const LevelLine before = splitLevelLine(lines_[index]);
  const std::vector<LevelToken>& tokens = before.tokens;
  const auto beginOf = [&](std::size_t token) { return static_cast<std::size_t>(tokens[token].column) - 1; };
  std::string line(before.text.substr(0, beginOf(0)));
  std::size_t end = 0;  // of the last token that has been replaced
  for (std::size_t i = 0; i < words.size(); ++i) {
    const bool isThere = i < tokens.size();
    if (i > 0) line += isThere ? before.text.substr(end, beginOf(i) - end) : " ";
    if (isThere) end = beginOf(i) + tokens[i].text.size();
    const bool same = isThere && i < 4 && numberOf(tokens[i].text) == numberOf(words[i]);
    line += same ? tokens[i].text : std::string_view(words[i]);
  }
  lines_[index] = line.append(before.text.substr(static_cast<std::size_t>(before.end) - 1));
  scan();
}

void LevelDocument::add(const EditedSegment& segment) {
  std::size_t after = faceMarks_[static_cast<std::size_t>(segment.face)];
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    if (segments_[i].face == segment.face) after = textLines_[i];
  }
  if (!lines_[after].ends_with('\n')) lines_[after] += lineEnd();
  lines_.insert(lines_.begin() + static_cast<std::ptrdiff_t>(after) + 1,
                joined(wordsOf(segment), " ") + std::string(lineEnd()));
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
    const LevelLine line = splitLevelLine(lines_[index]);
    if (!line.comment.empty()) kept.emplace_back(line.text.substr(static_cast<std::size_t>(line.commentColumn) - 1));
  }
  lines_ = std::move(kept);
  scan();
}

void LevelDocument::setStart(const FacePlace& start, int degrees) {
  rewrite(header_[kStart], {std::to_string(start.face), coordinateText(start.place.x), coordinateText(start.place.y),
                            std::to_string(degrees)});
}

void LevelDocument::turnStart(int degrees) {
  const LevelLine line = splitLevelLine(lines_[header_[kStart]]);
  std::vector<std::string> words;
  for (const LevelToken& token : line.tokens) words.emplace_back(token.text);
  words.back() = std::to_string(degrees);
  rewrite(header_[kStart], words);
}

void LevelDocument::setGoal(const FacePlace& goal) {
  rewrite(header_[kGoal], {std::to_string(goal.face), coordinateText(goal.place.x), coordinateText(goal.place.y)});
}

namespace {

constexpr std::array<int, kSolidKinds> kFaceSizes{640, 480, 560, 320, 480};  // by SolidKind
constexpr int kGrid = 10;

int onGrid(double value) { return static_cast<int>(std::floor(value / kGrid)) * kGrid; }

}  // namespace

std::string newLevelText(SolidKind solid, const std::string& title) {
  const int size = kFaceSizes[static_cast<std::size_t>(solid)];
  const SolidFrame frame(solid, size);
  const int floor = -onGrid(frame.apothem() * 0.75);
  const int half = onGrid(frame.apothem() * 0.75);
  const int ball = static_cast<int>(LevelMarks::kBallRadius);
  const std::string segment = std::to_string(-half) + " " + std::to_string(floor) + " " + std::to_string(half) + " " +
                              std::to_string(floor) + "\n";
  std::string text = "# title: " + title + "\n" + std::string(nameOf(solid)) + "\n";
  text += "0 " + std::to_string(-half / 2) + " " + std::to_string(floor + ball) + " 0\n";
  text += "0 " + std::to_string(half / 2) + " " + std::to_string(floor + 2 * kGrid) + "\n";
  text += std::to_string(size) + "\n";
  for (int face = 0; face < frame.faces(); ++face) {
    text += "%  # face " + std::to_string(face) + "\n" + (face == 0 ? segment : "");
  }
  return text;
}

std::string titleOf(const std::string& fileName) {
  std::string title = fileName.substr(0, fileName.rfind(".level"));
  title.erase(0, std::min(title.find_first_not_of("0123456789_- "), title.size()));
  std::replace(title.begin(), title.end(), '_', ' ');
  std::erase_if(title, [](char letter) { return letter < ' ' || letter > '~'; });
  if (title.empty()) return "New level";
  title[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(title[0])));
  return title.substr(0, 100);
}

}  // namespace platon
